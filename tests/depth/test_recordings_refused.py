"""Depth recordings that cannot be used: one sentence each that names the file and the field."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from kinect.depth.recorder import DepthRecorder
from kinect.depth.recording import DepthRecordingError, open_depth_recording
from tests.depth.depth_sessions import raw_pictures, session, write_fakenect

RAW = raw_pictures(2)
TICKS = np.array([10, 2_002_165], dtype=np.uint32)


def play(path: Path) -> None:
    for frame in open_depth_recording(path):
        frame.metres()


def refusal(path: Path) -> str:
    with pytest.raises(DepthRecordingError) as caught:
        play(path)
    words = str(caught.value)
    assert "valid:" in words and words.endswith(".") and "\n" not in words
    return words


@pytest.mark.parametrize(
    ("fields", "named"),
    [
        ({"depth": RAW}, "neither raw11 nor depth_mm"),
        ({"raw11": RAW}, "ticks is missing"),
        ({"raw11": RAW.astype(np.int32), "ticks": TICKS}, "raw11 is int32"),
        ({"raw11": RAW[:, :240], "ticks": TICKS}, "raw11 is uint16 of shape (2, 240, 640)"),
        ({"raw11": RAW[:0], "ticks": TICKS[:0]}, "raw11 is uint16 of shape (0, 480, 640)"),
        ({"raw11": RAW + np.uint16(2000), "ticks": TICKS}, "raw11 holds the value 4047"),
        ({"raw11": RAW, "ticks": TICKS[:1]}, "ticks is uint32 of shape (1,)"),
        ({"raw11": RAW, "ticks": np.array([0.0, np.nan])}, "ticks is not finite in frame 1"),
        ({"raw11": RAW, "ticks": TICKS, "accel": np.zeros((5, 3), int)}, "accel has 5 rows"),
        ({"raw11": RAW, "ticks": TICKS, "accel": np.zeros((2, 2), int)}, "accel is int64 of shape (2, 2)"),
        ({"raw11": RAW, "ticks": TICKS, "calibration": np.array([1.2, 0.0, 0.075, 200.0])}, "calibration is"),
        ({"raw11": RAW, "ticks": TICKS, "calibration": np.array([1.2, 0.001, 0.075, 200.0])}, "intrinsics is missing"),
        ({"depth_mm": RAW}, "t_us is missing"),
        ({"depth_mm": RAW, "t_us": np.array(["a", "b"])}, "t_us is str"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_an_archive_with_a_wrong_field_is_refused_by_that_field_s_name(tmp_path: Path, fields: dict, named: str) -> None:
    path = tmp_path / "broken.npz"
    np.savez(path, **fields)
    words = refusal(path)
    assert words.startswith("broken.npz: ") and named in words


def spoil_header(picture: Path, _: Path) -> None:
    picture.write_bytes(b"P6 640 480 255\n" + picture.read_bytes()[17:])


def shorten(picture: Path, _: Path) -> None:
    picture.write_bytes(picture.read_bytes()[:-10])


def remove(picture: Path, _: Path) -> None:
    picture.unlink()


def lengthen_values(picture: Path, _: Path) -> None:
    picture.write_bytes(picture.read_bytes()[:17] + b"\xff\x0f" * 307_200)


@pytest.mark.parametrize(
    ("spoil", "named"),
    [(spoil_header, "header"), (shorten, "614390 octets"), (remove, "cannot be read"), (lengthen_values, "holds the value 4095")],
)
def test_a_fakenect_session_with_a_broken_picture_names_that_picture(
    tmp_path: Path, spoil: Callable[[Path, Path], None], named: str
) -> None:
    folder = tmp_path / "fake"
    write_fakenect(folder, session(2, typical=True))
    picture = folder / next(line for line in (folder / "INDEX.txt").read_text().split() if line.startswith("d-"))
    spoil(picture, folder)
    words = refusal(folder)
    assert words.startswith(picture.name) and named in words


def test_an_index_of_something_else_is_refused_by_line(tmp_path: Path) -> None:
    (tmp_path / "INDEX.txt").write_text("d-1.0-5.pgm\nhello\nd-2.0-6.pgm\n")
    assert "'hello' in line 2" in refusal(tmp_path)
    (tmp_path / "INDEX.txt").write_bytes(b"\xff\xfe\x00")
    assert "INDEX.txt cannot be read" in refusal(tmp_path)
    (tmp_path / "INDEX.txt").write_text("r-1.0-5.ppm\n")
    assert "no whole depth frame" in refusal(tmp_path)


def test_what_is_no_recording_at_all_is_refused_with_what_would_be(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("hello")
    (tmp_path / "text.npz").write_text("hello")
    (tmp_path / "empty").mkdir()
    assert "no such file" in refusal(tmp_path / "missing")
    assert "notes.txt" in refusal(tmp_path / "notes.txt")
    assert "not a zip archive" in refusal(tmp_path / "text.npz")
    assert "no recording in this folder" in refusal(tmp_path / "empty")


def test_a_cut_or_altered_file_is_refused_and_nothing_else_is_raised(tmp_path: Path) -> None:
    np.savez_compressed(tmp_path / "good.npz", raw11=RAW, ticks=TICKS)
    octets = (tmp_path / "good.npz").read_bytes()
    rng = np.random.default_rng(7)
    path = tmp_path / "altered.npz"
    refused = 0
    for k in range(60):
        altered = bytearray(octets[: rng.integers(1, len(octets))] if k % 2 else octets)
        for place in rng.integers(0, len(altered), 3):
            altered[place] ^= int(rng.integers(1, 256))
        path.write_bytes(altered)
        try:
            play(path)
        except DepthRecordingError as fault:
            refused += "altered.npz" in str(fault)
    assert refused >= 55


def test_a_recording_is_never_written_over_something(tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("keep me")
    with pytest.raises(DepthRecordingError, match="not empty"):
        DepthRecorder(tmp_path)
    with pytest.raises(DepthRecordingError, match="no folder can be made"):
        DepthRecorder(tmp_path / "mine.txt" / "out")
