"""A recording that cannot be used gives one sentence with the file, the field and what would be valid."""

import io
import pickle
import zipfile

import numpy as np
import pytest

from kinect.clip import ClipError, read_clip, write_clip
from tests.kinect.recordings import moving_clip, raw_fields, standing_joints


def failure(path) -> str:
    with pytest.raises(ClipError) as caught:
        read_clip(path)
    sentence = str(caught.value)
    assert path.name in sentence and "valid:" in sentence and sentence.endswith(".") and "\n" not in sentence
    return sentence


def spoil(**changes) -> dict[str, np.ndarray]:
    return raw_fields(moving_clip()) | changes


CASES = {
    "positions of 19 joints": (spoil(positions=np.zeros((40, 19, 3))), "positions has shape (40, 19, 3)"),
    "positions as text": (spoil(positions=np.full((40, 20, 3), "a")), "positions holds"),
    "no frames": (spoil(positions=np.zeros((0, 20, 3)), t=np.zeros(0), confidence=np.zeros((0, 20))), "positions holds no frames"),
    "nothing but NaN": (spoil(positions=np.full((40, 20, 3), np.nan)), "no finite joint"),
    "millimetres": (spoil(positions=moving_clip().positions * 1000.0), "not millimetres"),
    "too few times": (spoil(t=np.arange(7) / 30.0), "t has shape (7,)"),
    "a time that is not finite": (spoil(t=np.where(np.arange(40) == 3, np.nan, np.arange(40) / 30.0)), "t is not finite in frame 3"),
    "time backwards": (spoil(t=-np.arange(40) / 30.0), "t runs backwards"),
    "time that stands still": (spoil(t=np.zeros(40)), "stands still"),
    "milliseconds": (spoil(t=np.arange(40) * 33.0), "t advances by 33 a frame"),
    "a year": (spoil(t=np.append(np.arange(39) / 30.0, 3e7)), "t spans 3e+07 s"),
    "confidence of one joint": (spoil(confidence=np.ones(40)), "confidence has shape (40,)"),
    "confidence of two": (spoil(confidence=np.full((40, 20), 2.0)), "confidence reaches"),
    "a floor of three": (spoil(floor=np.array([0.0, 1.0, 0.0])), "floor has 3 numbers"),
    "a floor without normal": (spoil(floor=np.array([0.0, 0.0, 0.0, 1.0])), "floor is [0.0, 0.0, 0.0, 1.0], not a plane"),
    "a wall": (spoil(floor=np.array([0.0, 0.0, 1.0, 1.0])), "floor is [0.0, 0.0, 1.0, 1.0]"),
    "half a floor": (spoil(floor_est=np.array([0.0, np.nan, 0.0, 1.0])), "floor_est is"),
    "joints in another order": (spoil(joint_names=np.array(["Head"] * 20)), "joint_names has 'Head' in place of 'HipCenter'"),
    "no rate": (spoil(fps=np.array(0.0)), "fps is [0.0]"),
}


@pytest.mark.parametrize("case", CASES)
def test_a_field_that_is_wrong_is_named(tmp_path, case):
    fields, words = CASES[case]
    np.savez(tmp_path / "bad.npz", **fields)  # pyright: ignore[reportArgumentType]
    assert words in failure(tmp_path / "bad.npz")


def test_a_missing_field_is_named(tmp_path):
    np.savez(tmp_path / "a.npz", t=np.zeros(3))
    assert "the key positions is missing" in failure(tmp_path / "a.npz")
    np.savez(tmp_path / "b.npz", positions=moving_clip().positions)
    assert "the key t is missing" in failure(tmp_path / "b.npz")


def test_objects_in_an_archive_are_refused_without_being_unpickled(tmp_path):
    class Trap:
        def __reduce__(self):
            return (open, (str(tmp_path / "sprung"), "w"))

    member = io.BytesIO()
    header = {"descr": "|O", "fortran_order": False, "shape": (1,)}
    np.lib.format.write_array_header_1_0(member, header)
    member.write(pickle.dumps([Trap()]))
    with zipfile.ZipFile(tmp_path / "trap.npz", "w") as archive:
        archive.writestr("positions.npy", member.getvalue())
    assert "positions cannot be read" in failure(tmp_path / "trap.npz")
    assert not (tmp_path / "sprung").exists()


def test_files_that_are_no_archives(tmp_path):
    empty, text, cut = tmp_path / "empty.npz", tmp_path / "text.npz", tmp_path / "cut.npz"
    empty.write_bytes(b"")
    assert "empty" in failure(empty)
    text.write_text("hello")
    assert "not a zip archive" in failure(text)
    write_clip(tmp_path / "whole.npz", moving_clip())
    cut.write_bytes((tmp_path / "whole.npz").read_bytes()[:900])
    assert "cut off" in failure(cut)


def test_files_that_are_not_there_or_of_another_kind(tmp_path):
    assert "no such file" in failure(tmp_path / "nowhere.npz")
    assert "the suffix '.mp4'" in failure(tmp_path / "film.mp4")
    with pytest.raises(ClipError, match="the suffix"):
        write_clip(tmp_path / "clip.mp4", moving_clip())
    with pytest.raises(ClipError, match="cannot be written"):
        write_clip(tmp_path / "no" / "folder.npz", moving_clip())


ROW = ",".join(f"{x},{y},{z},1" for x, y, z in standing_joints())


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "no rows"),
        ("# only a remark\nx,y,z\n", "no rows"),
        (ROW + "\n1,2,3\n", "line 2 has 3 columns"),
        (ROW + "\n0.1," + ROW + "\n", "line 2 has 81 columns where the first has 80"),
        (ROW.replace("2.5", "two", 1) + "\n", "line 1 column 3 is 'two'"),
        (ROW + "\n" + ROW.replace("2.5", "1e", 1), "line 2 column 3 is '1e'"),
        (ROW[:-1] + "3\n" + ROW, "state holds 3"),
        ("nan," + ROW, "t is not finite in frame 0"),
        ("# floor: 0 up 0 1\n" + ROW, "floor is '0 up 0 1'"),
        ("\n".join(f"{33 * k},{ROW}" for k in range(5)), "t advances by 33"),
    ],
)
def test_a_line_of_text_that_is_wrong_is_named(tmp_path, text, words):
    (tmp_path / "bad.csv").write_text(text)
    assert words in failure(tmp_path / "bad.csv")


def test_bytes_that_are_no_text_are_named(tmp_path):
    (tmp_path / "bad.csv").write_bytes(ROW.encode() + b"\n\xff\xfe")
    assert "is not text" in failure(tmp_path / "bad.csv")
