"""Finished pictures out of the graphics card: to an array, to a PNG, to a video."""

from fractions import Fraction
from pathlib import Path
from types import TracebackType
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

Pixels = NDArray[np.uint8]


def read_pixels(framebuffer: moderngl.Framebuffer, size: tuple[int, int]) -> Pixels:
    """The picture (height, width, 3) as sRGB bytes, top row first. Raises RuntimeError where drawing it left an OpenGL error."""
    context = framebuffer.ctx
    error = context.error
    if error != "GL_NO_ERROR":
        raise RuntimeError(f"drawing the picture left the OpenGL error {error}.")
    data = framebuffer.read(viewport=(0, 0, *size), components=3, alignment=1)
    if framebuffer.glo == 0:
        _ = context.error  # moderngl asks for a colour attachment, which the window's own framebuffer refuses harmlessly
    return np.frombuffer(data, dtype=np.uint8).reshape(size[1], size[0], 3)[::-1]


def save_png(path: Path | str, pixels: Pixels) -> None:
    """Write a picture (height, width, 3); folders are made as needed."""
    from PIL import Image

    Path(path).parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(np.ascontiguousarray(pixels)).save(path)


class VideoError(RuntimeError):
    """The video cannot be written; the message names the file and the cause."""


class VideoWriter:
    """Writes an MP4 of pictures of one size (width, height) at a whole or fractional number of frames per second.

    H.264 where the installed FFmpeg has it, else MPEG-4 part 2. An odd width or height loses its last column or row, as H.264 asks.
    Raises VideoError.
    """

    def __init__(self, path: Path | str, size: tuple[int, int], fps: float) -> None:
        self.path = Path(path)
        self._size = (size[0] // 2 * 2, size[1] // 2 * 2)
        if min(self._size) < 2:
            raise VideoError(f"{self.path}: a video needs pictures of at least 2 x 2 pixels, not {size[0]} x {size[1]}.")
        self._container: Any
        self._container, self._stream, self.codec = self._open(fps)
        self.frames = 0

    def _open(self, fps: float) -> tuple[Any, Any, str]:
        try:
            import av
            from av.error import FFmpegError
        except ImportError as missing:
            raise VideoError(
                f"{self.path}: no video can be written because PyAV cannot be loaded ({missing}); pip install av."
            ) from missing
        codec = next((name for name in ("libx264", "mpeg4") if name in av.codecs_available), None)
        if codec is None:
            raise VideoError(f"{self.path}: this build of FFmpeg encodes neither H.264 nor MPEG-4.")
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            container = av.open(str(self.path), "w", format="mp4")
            stream: Any = container.add_stream(codec, rate=Fraction(fps).limit_denominator(1001))
        except (OSError, FFmpegError) as broken:
            raise VideoError(f"{self.path}: the video cannot be opened for writing ({broken}).") from broken
        stream.width, stream.height = self._size
        stream.pix_fmt = "yuv420p"
        if codec == "libx264":
            stream.options = {"crf": "20", "preset": "veryfast"}
        else:
            stream.bit_rate = 6_000_000
        return container, stream, codec

    def add(self, pixels: Pixels) -> None:
        """Append one picture (height, width, 3), top row first."""
        from av import VideoFrame
        from av.error import FFmpegError

        width, height = self._size
        try:
            frame = VideoFrame.from_ndarray(np.ascontiguousarray(pixels[:height, :width]), format="rgb24")
            for packet in self._stream.encode(frame):
                self._container.mux(packet)
        except (OSError, FFmpegError) as broken:
            raise VideoError(f"{self.path}: the video cannot be written ({broken}).") from broken
        self.frames += 1

    def close(self) -> None:
        """Finish the file; calling it twice is harmless."""
        if self._container is None:
            return
        if self.frames:
            for packet in self._stream.encode():
                self._container.mux(packet)
        self._container.close()
        self._container = None

    def __enter__(self) -> "VideoWriter":
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()
