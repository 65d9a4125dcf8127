"""The door run end to end: what a run without and with a picture leaves, and that drawing changes nothing."""

import json
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from game.characters.skeleton import JOINTS
from game.commands import main
from game.tunables import TUNABLES
from kinect.clip import write_clip
from tests.door.the_door import knock, read_report
from tests.kinect.recordings import moving_clip

NUMBER = (int, float)
MAYBE = (int, float, type(None))
KEYS: dict[str, type | tuple[type, ...]] = {
    **dict.fromkeys(("scene", "input", "character", "state_sha256"), str),
    **dict.fromkeys(("clip_s", "upright_s", "simulated_s", "real_time_factor"), NUMBER),
    "fell_at_s": MAYBE,
    **dict.fromkeys(("joint_error_parent_rad", "joint_error_world_rad", "end_effector_error_m"), MAYBE),
    **dict.fromkeys(("joint_error_parent_rad_vs_mapped", "joint_error_world_rad_vs_mapped", "end_effector_error_m_vs_mapped"), MAYBE),
    **dict.fromkeys(("worst_joint", "worst_joint_vs_mapped"), (str, type(None))),
    **dict.fromkeys(("wrist_lag_s", "wrist_path_ratio"), MAYBE),
    **dict.fromkeys(("unexplained_force_max_n", "unexplained_torque_max_nm"), NUMBER),
    **dict.fromkeys(("contact_partners", "pushes"), list),
    **dict.fromkeys(("guard_actions", "warnings", "seed"), int),
    **dict.fromkeys(("ms_per_frame", "peak_torque_nm", "versions", "settings"), dict),
}
"""What issue and acceptance ask the report for, and of which type."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A foreign folder with a recording in it."""
    place = tmp_path_factory.mktemp("foreign")
    write_clip(place / "sway.npz", moving_clip())
    write_clip(place / "sway.csv", moving_clip())
    return place


@pytest.fixture(scope="module")
def undrawn(folder: Path) -> dict[str, Any]:
    """The report of half a second of boxing without a picture."""
    visit = knock(folder, "--no-draw", "--input", "performer:boxing", "--seconds", "0.5", "--report", "deep/down/boxing.json")
    assert (visit.status, visit.err) == (0, "")
    return read_report(folder / "deep/down/boxing.json")


def run_here(folder: Path, *words: str) -> dict[str, Any]:
    """The report of the same command line without a picture, run in this process, which has imported everything already."""
    assert main(("--no-draw", *words, "--report", str(folder / "here.json"))) == 0
    return read_report(folder / "here.json")


def test_the_report_says_everything_it_is_asked_for(undrawn: dict[str, Any]) -> None:
    assert {key for key in KEYS if key not in undrawn} == set()
    assert {key: undrawn[key] for key, kind in KEYS.items() if not isinstance(undrawn[key], kind)} == {}
    assert (undrawn["scene"], undrawn["input"], undrawn["character"]) == ("mirror", "performer:boxing", "original")
    assert undrawn["clip_s"] == pytest.approx(15.6)
    assert undrawn["simulated_s"] == pytest.approx(0.5)
    assert undrawn["upright_s"] == pytest.approx(0.5) and undrawn["fell_at_s"] is None
    assert len(undrawn["state_sha256"]) == 64
    assert set(undrawn["ms_per_frame"]) == {"target", "control", "physics", "draw"}
    assert undrawn["ms_per_frame"]["draw"] == 0.0 and undrawn["ms_per_frame"]["physics"] > 0.0
    assert set(undrawn["peak_torque_nm"]) == set(JOINTS)
    assert undrawn["peak_torque_nm"]["knee_left"] > 1.0
    assert undrawn["contact_partners"] == ["floor - c0"] and undrawn["pushes"] == []
    assert undrawn["settings"] == {name: t.default for name, t in TUNABLES.items()}
    assert {"topple", "python", "mujoco", "numpy"} <= set(undrawn["versions"])
    assert undrawn["real_time_factor"] > 0.0


def test_nothing_but_contact_moved_the_root(undrawn: dict[str, Any]) -> None:
    assert undrawn["unexplained_force_max_n"] < 1e-6
    assert undrawn["unexplained_torque_max_nm"] < 1e-6
    assert (undrawn["guard_actions"], undrawn["warnings"]) == (0, 0)


def test_a_fall_is_no_error(folder: Path) -> None:
    # the person bows to the floor and stays there, with joints too weak to follow
    visit = knock(
        folder, "--no-draw", "--input", "performer:bowing", "--seconds", "3", "--balance", "none", "--set", "pd.kp_hat=100", "--set",
        "pd.gravity_feedforward=off", "--report", "fall.json",
    )  # fmt: skip
    report = read_report(folder / "fall.json")
    assert visit.status == 0 and "fell after" in visit.out
    assert 0.0 < report["fell_at_s"] < 3.0
    assert report["upright_s"] < report["fell_at_s"]
    assert report["simulated_s"] == pytest.approx(3.0), "the run goes on after the fall"


def test_recordings_of_both_kinds_are_played_to_their_end(folder: Path) -> None:
    for name in ("sway.npz", "sway.csv"):
        report = run_here(folder, "--input", f"clip:{folder / name}")
        assert report["clip_s"] == pytest.approx(39 / 30.0, abs=0.04)
        assert report["simulated_s"] == pytest.approx(report["clip_s"], abs=0.04)


def test_drawing_changes_no_state(folder: Path, undrawn: dict[str, Any]) -> None:
    for gl in ("egl", "osmesa"):
        words = ("--headless", "--input", "performer:boxing", "--seconds", "0.5", "--size", "64x64", "--quality", "low")
        visit = knock(folder, *words, "--report", "drawn.json", "--picture", f"new/{gl}.png", "--video", f"{gl}.mp4", TOPPLE_GL=gl)
        if visit.status == 2 and any(word in visit.err for word in ("OpenGL", "OSMesa")):
            pytest.skip(visit.err)
        assert visit.status == 0, visit.err
        report = read_report(folder / "drawn.json")
        assert report["state_sha256"] == undrawn["state_sha256"]
        assert report["gl"] == gl and report["drawn"] is True
        assert report["ms_per_frame"]["draw"] > 0.0
        assert report["files"] == [f"{gl}.mp4", f"new/{gl}.png"]
        assert (folder / f"{gl}.mp4").stat().st_size > 500
        with Image.open(folder / "new" / f"{gl}.png") as picture:
            assert picture.size == (64, 64)
            colours = picture.convert("RGB").getcolors(64 * 64)
            assert colours is not None and len(colours) > 200, "a room with a person in it has many colours"


def test_another_clip_or_seed_or_character_is_another_run(folder: Path, undrawn: dict[str, Any]) -> None:
    boxing = ("--input", "performer:boxing")
    noisy = (*boxing, "--set", "sensor.noise=0.3", "--seed")
    others = (("--input", "performer:waving"), (*boxing, "--character", "low-com"), (*noisy, "1"), (*noisy, "2"))
    runs = [undrawn["state_sha256"], *(run_here(folder, *words, "--seconds", "0.5")["state_sha256"] for words in others)]
    assert len(set(runs)) == len(runs)
    assert run_here(folder, *noisy, "2", "--seconds", "0.5")["state_sha256"] == runs[-1]


def test_a_process_of_its_own_and_this_one_compute_the_same(folder: Path, undrawn: dict[str, Any]) -> None:
    assert run_here(folder, "--input", "performer:boxing", "--seconds", "0.5")["state_sha256"] == undrawn["state_sha256"]


def test_a_duel_reports_its_score(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    report = run_here(folder, "--input", "script", "--scene", "duel", "--seconds", "0.5")
    assert "duel, You 0 : 0 Opponent" in capsys.readouterr().out
    assert (report["scene"], report["score"], report["rounds"]) == ("duel", "You 0 : 0 Opponent", [])
    assert {"floor - c0", "floor - c1"} <= set(report["contact_partners"])
    assert report["unexplained_force_max_n"] < 1e-6


def test_without_graphics_nothing_that_draws_is_imported(folder: Path) -> None:
    words = ("--no-draw", "--input", "performer:standing", "--seconds", "0.1", "--report", "bare.json")
    visit = knock(folder, *words, python=("-X", "importtime"))
    assert visit.status == 0
    imported = {line.split("|")[-1].strip() for line in visit.err.splitlines() if line.startswith("import time:")}
    assert {"numpy", "mujoco", "game.scenes.mirror"} <= imported
    drawing = {"moderngl", "glfw", "imgui_bundle", "av", "PIL", "game.render", "game.overlay", "OpenGL"}
    assert {name for name in imported if name in drawing or name.split(".")[0] in drawing} == set()


def test_without_a_display_the_plain_command_says_where_it_draws(folder: Path) -> None:
    visit = knock(folder, "--seconds", "0.1", "--quality", "low")
    assert visit.status == 0, visit.err
    video, picture = Path("topple-output/topple.mp4"), Path("topple-output/topple.png")
    assert f"no display here, so performer:boxing is drawn off-screen into {video} and {picture}." in visit.out
    assert (folder / video).stat().st_size > 500
    with Image.open(folder / picture) as drawn:
        assert drawn.size == (960, 540)
    assert "100 %" in visit.err


def test_every_tunable_is_listed_with_what_is_valid(folder: Path) -> None:
    visit = knock(folder, "--list-tunables")
    assert (visit.status, visit.err) == (0, "")
    lines = visit.out.splitlines()
    assert [line.split(" = ")[0] for line in lines] == list(TUNABLES)
    assert all(t.meaning in line for t, line in zip(TUNABLES.values(), lines, strict=True))


def test_a_number_that_is_none_is_null_in_the_report(tmp_path: Path) -> None:
    from game.commands.output_file import write_report

    write_report(tmp_path / "r.json", {"a": float("nan"), "b": [1.0, float("inf")], "c": {"d": (2, None, "word")}})
    assert read_report(tmp_path / "r.json") == {"a": None, "b": [1.0, None], "c": {"d": [2, None, "word"]}}
    (tmp_path / "broken.json").write_text(json.dumps({"a": float("nan")}))
    with pytest.raises(ValueError, match="NaN"):
        read_report(tmp_path / "broken.json")


def test_no_log_of_the_physics_engine_is_left_behind(folder: Path) -> None:
    # last in the file: it looks at what all runs above have left
    words = ("--input", "performer:boxing", "--set", "physics.integrator=explicit", "--set", "physics.step_s=0.01")
    assert knock(folder, "--no-draw", "--seconds", "0.5", *words).status == 0
    assert [path.name for path in folder.rglob("MUJOCO_LOG.TXT")] == []
