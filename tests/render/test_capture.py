"""Pictures and videos come out as they were drawn."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from game.render.capture import VideoError, VideoWriter, save_png


def test_a_png_holds_the_pixels(tmp_path: Path) -> None:
    pixels = np.arange(3 * 5 * 3, dtype=np.uint8).reshape(3, 5, 3)
    save_png(tmp_path / "new" / "a.png", pixels)
    assert np.array_equal(np.asarray(Image.open(tmp_path / "new" / "a.png")), pixels)


def test_a_video_plays_back_what_was_added(tmp_path: Path) -> None:
    import av

    path = tmp_path / "a.mp4"
    with VideoWriter(path, (65, 49), 30) as video:  # odd sizes lose a line
        for i in range(12):
            frame = np.zeros((49, 65, 3), dtype=np.uint8)
            frame[:, : 5 * i] = 255
            video.add(frame)
        assert video.frames == 12
    with av.open(str(path)) as played:
        frames = [frame.to_ndarray(format="rgb24") for frame in played.decode(video=0)]
        assert played.streams.video[0].average_rate == 30
    assert len(frames) == 12
    assert frames[0].shape == (48, 64, 3)
    assert (frames[11][24, :, 0] > 128).sum() == pytest.approx(55, abs=2)


def test_a_video_that_cannot_be_written_names_the_file(tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("a file, not a folder")
    with pytest.raises(VideoError, match=r"taken.*a\.mp4"):
        VideoWriter(tmp_path / "taken" / "a.mp4", (64, 48), 30)


def test_a_video_of_nothing_is_refused(tmp_path: Path) -> None:
    with pytest.raises(VideoError, match="at least 2 x 2"):
        VideoWriter(tmp_path / "a.mp4", (1, 48), 30)


def test_an_opengl_error_does_not_pass_unseen(window) -> None:
    from game.render.capture import read_pixels

    class Broken:
        error = "GL_INVALID_VALUE"

    class Frame:
        ctx = Broken()

    with pytest.raises(RuntimeError, match="GL_INVALID_VALUE"):
        read_pixels(Frame(), (4, 4))  # type: ignore[arg-type]
