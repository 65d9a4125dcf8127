"""A Dear ImGui of its own, without inputs: built some times a second, and drawn every frame as it was built last."""

from collections.abc import Iterator
from contextlib import contextmanager

from imgui_bundle import ImVec2, imgui, implot

from game.overlay.style import Fonts, apply_style, load_fonts

_AWAY = -1e9


class StillLayer:
    """Lies over the same screen as the context that is current when it is made, which is current again after every call."""

    def __init__(self) -> None:
        self._main = imgui.get_current_context()
        self._context = imgui.create_context()
        self._plots = implot.create_context()
        self._scale = 0.0
        self._built = False
        with self._current():
            io = imgui.get_io()
            io.set_ini_filename("")
            io.set_log_filename("")
            io.add_mouse_pos_event(_AWAY, _AWAY)
            self.fonts: Fonts = load_fonts()
            imgui.backends.opengl3_init("#version 330")

    @contextmanager
    def building(self, size: tuple[float, float], scale: float) -> Iterator[None]:
        """Build the layer anew with what is asked of Dear ImGui and ImPlot within; size: of the screen, scale: of the overlay."""
        pixels = imgui.get_io().display_framebuffer_scale
        with self._current():
            if scale != self._scale:
                self._scale = scale
                apply_style(scale)
            io = imgui.get_io()
            io.display_size = ImVec2(*size)
            io.display_framebuffer_scale = ImVec2(pixels.x, pixels.y)
            imgui.backends.opengl3_new_frame()
            imgui.new_frame()
            try:
                yield
            finally:
                imgui.render()
                self._built = True

    def draw(self) -> None:
        """Onto the default framebuffer, whose viewport is the whole window."""
        if self._built:
            with self._current():
                imgui.backends.opengl3_render_draw_data(imgui.get_draw_data())

    def close(self) -> None:
        with self._current():
            imgui.backends.opengl3_shutdown()
        implot.destroy_context(self._plots)
        imgui.destroy_context(self._context)

    @contextmanager
    def _current(self) -> Iterator[None]:
        imgui.set_current_context(self._context)
        implot.set_current_context(self._plots)
        try:
            yield
        finally:
            imgui.set_current_context(self._main)
