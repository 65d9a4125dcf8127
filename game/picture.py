"""The window with everything that is drawn in it: scene, camera, overlay, and what happens at it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from game.drawables import Label, Layer
from game.render.camera import Camera
from game.render.gl_window import GLWindow, open_gl
from game.scenes.scene import Scene
from game.tunables import Settings

if TYPE_CHECKING:
    from game.app import Options
    from game.overlay.ui import Overlay
    from game.window_events import WindowEvents

TITLE = "Topple"


class Picture:
    """Opens the window and draws into it. Raises NoPicture. overlay and events are None where there is only memory (OSMesa)."""

    def __init__(self, scene: Scene, settings: Settings, options: Options, renderer: Any = None) -> None:
        self.settings = settings
        self.window: GLWindow = open_gl(*options.size, TITLE, headless=options.headless)
        self.overlay: Overlay | None = None
        self.events: WindowEvents | None = None
        self.layers: tuple[Layer, ...] = ()
        try:
            self._renderer = renderer or _renderer(self.window, options.quality, settings)
            if self.window.handle is not None:
                self._listen(options.overlay)
        except BaseException:
            self.window.close()
            raise
        self._gl = self.window.ctx
        self.cut(scene)

    def _listen(self, with_overlay: bool) -> None:
        from game.window_events import WindowEvents

        self.events = events = WindowEvents(self.window.handle)
        if not with_overlay:
            return
        from game.overlay.ui import Overlay

        self.overlay = overlay = Overlay(self.window.handle)
        events.mouse_taken = lambda: overlay.wants_mouse
        events.typing = lambda: overlay.wants_text

    def cut(self, scene: Scene) -> None:
        """Put the camera where the scene would like it."""
        self.camera = Camera(next(iter(scene.cameras().values())))

    def draw(self, scene: Scene, blend: float, frame_s: float) -> None:
        """Move the camera as the mouse asks and draw the scene; frame_s: seconds since the last picture."""
        self._steer_camera(frame_s)
        self.layers = scene.drawables(blend)
        self._renderer.render(self.layers, self.camera, self.window.screen, self.window.framebuffer_size)
        self.window.screen.use()

    def labels(self) -> list[tuple[float, float, Label]]:
        """Where the words of the layers that are switched on stand, overlay units from the top left."""
        if self.overlay is None:
            return []
        size, units = self.window.framebuffer_size, self.overlay.size
        placed: list[tuple[float, float, Label]] = []
        for layer in self.layers:
            for item in layer.drawables:
                if isinstance(item, Label) and self._shows(layer):
                    at = self.camera.project(item.position, size, self.settings.number("picture.fov_deg"))
                    if at is not None:
                        placed.append((at[0] * units[0] / size[0], at[1] * units[1] / size[1], item))
        return placed

    def _shows(self, layer: Layer) -> bool:
        name = f"layer.{layer.name}"
        return name not in self.settings.as_dict() or self.settings.switch(name)

    def _steer_camera(self, frame_s: float) -> None:
        self.camera.advance(frame_s)
        if self.events is None:
            return
        height = max(1.0, float(self.window.framebuffer_size[1] if self.overlay is None else self.overlay.size[1]))
        orbit, pan, wheel = self.events.mouse.take()
        if orbit != (0.0, 0.0):
            self.camera.orbit(-orbit[0] / height * math.pi, orbit[1] / height * math.pi)
        if pan != (0.0, 0.0):
            self.camera.pan(-pan[0] / height, pan[1] / height)
        if wheel:
            self.camera.zoom(0.9**wheel)

    def close(self) -> None:
        """Give back overlay, renderer and window. Calling it twice is harmless."""
        if self.overlay is not None:
            self.overlay.close()
        release = getattr(self._renderer, "release", None)
        if release is not None:
            release()
        self.window.close()


def _renderer(window: GLWindow, quality: str | None, settings: Settings) -> Any:
    from game.render.quality import usual_quality
    from game.render.renderer import Renderer

    return Renderer(window.ctx, quality or usual_quality(window.ctx.info["GL_RENDERER"]), settings)
