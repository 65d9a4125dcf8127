"""What a run leaves behind: the last frame as a picture, every frame as a video, screenshots."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.render.capture import VideoWriter, save_png
from game.render.gl_window import GLWindow


class Output:
    """Reads finished frames from the window's default framebuffer and writes them. Folders are made as needed."""

    def __init__(self, picture: Path | None, video: Path | None, fps: int, window: GLWindow) -> None:
        self._picture, self._window = picture, window
        self._video: VideoWriter | None = None
        self._newest: NDArray[np.uint8] | None = None
        self._files: list[Path] = []
        self._copy: Any = None
        self._closed = False
        if video is not None:
            self._video = VideoWriter(video, window.framebuffer_size, fps)
            self._files.append(video)

    def frame(self) -> None:
        """Take in the frame that was just drawn; call it before the frame is shown."""
        if self._video is None and self._picture is None:
            return
        self._newest = self.read()
        if self._video is not None:
            self._video.add(self._newest)

    def read(self) -> NDArray[np.uint8]:
        """The frame being drawn, (height, width, 3), top row first."""
        width, height = size = self._window.framebuffer_size
        if self._copy is None or self._copy.size != size:
            if self._copy is not None:
                self._copy.release()
            self._copy = self._window.ctx.simple_framebuffer(size, 3)
        # through a copy, since moderngl's read of the default framebuffer itself leaves a GL error behind
        self._window.ctx.copy_framebuffer(self._copy, self._window.screen)
        if self._window.kind == "osmesa":
            _ = self._window.ctx.error  # memory has no back buffer: moderngl names one all the same, and the copy is right
        pixels = np.frombuffer(self._copy.read(components=3, alignment=1), np.uint8)
        self._window.screen.use()
        return pixels.reshape(height, width, 3)[::-1]

    def screenshot(self, path: Path) -> None:
        """Write the frame being drawn as PNG. OSError where the folder cannot be written."""
        self._write(path, self.read())

    def close(self) -> list[Path]:
        """Write the last frame as the picture and finish the video; returns the files written. Calling it twice is harmless."""
        if not self._closed:
            self._closed = True
            if self._video is not None:
                self._video.close()
            if self._picture is not None and self._newest is not None:
                self._write(self._picture, self._newest)
        return self._files

    def _write(self, path: Path, pixels: NDArray[np.uint8]) -> None:
        save_png(path, pixels)
        self._files.append(path)
