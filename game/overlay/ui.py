"""The overlay of one window: Dear ImGui with its own GLFW and OpenGL back ends."""

import ctypes
from typing import Any

import glfw
from imgui_bundle import imgui

from game.overlay.depth_panel import DepthPanel
from game.overlay.hud import Hud
from game.overlay.ink import Ink
from game.overlay.menu import Menu, draw_help
from game.overlay.plots_panel import PlotsPanel
from game.overlay.style import apply_style, interface_scale, load_fonts
from game.overlay.tuning_panel import TuningPanel
from game.overlay.view import Shown, View


class Overlay:
    """Draws a View over the picture and takes keys and mouse first.

    Make it after the window's own GLFW callbacks are set: Dear ImGui puts itself before them and hands every event on.
    """

    def __init__(self, handle: Any) -> None:
        """handle: the GLFW window whose OpenGL context is current."""
        self.shown = Shown()
        self._handle = handle
        self._context = imgui.create_context()
        self._closed = False
        io = imgui.get_io()
        io.set_ini_filename("")  # positions are the layout's business, and no imgui.ini is left in the working directory
        io.set_log_filename("")
        self.fonts = load_fonts()
        self.address: int = ctypes.cast(handle, ctypes.c_void_p).value or 0
        imgui.backends.glfw_init_for_opengl(self.address, True)
        imgui.backends.opengl3_init("#version 330")
        self.hud = Hud()
        self.panel = TuningPanel(self.fonts)
        self.menu = Menu(self.fonts)
        self.depth = DepthPanel(self.fonts)
        self.plots = PlotsPanel()
        self._scale = 0.0
        self._ink: Ink | None = None
        self._rescale()

    @property
    def wants_mouse(self) -> bool:
        """True while the mouse is over, or dragging in, a window of the overlay."""
        self._make_current()
        return imgui.get_io().want_capture_mouse

    @property
    def wants_text(self) -> bool:
        """True while a text field takes the keys."""
        self._make_current()
        return imgui.get_io().want_text_input

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the screen in overlay units, the unit of mouse positions."""
        width, height = glfw.get_window_size(self._handle)
        return float(width), float(height)

    @property
    def scale(self) -> float:
        """Overlay units per pixel of the design at 720 lines."""
        return self._scale

    def plots_due(self, now_s: float) -> bool:
        """Whether the view of the frame at `now_s` needs plots and stages."""
        return self.plots.due(self.shown, now_s, self.size)

    def draw(self, view: View) -> None:
        """Build and draw one frame of the overlay into the default framebuffer, whose viewport is the whole window."""
        self._make_current()
        self._rescale()
        self._navigate(self.shown.menu)
        size = self.size
        self.plots.build(view, self.shown, size, self._scale)
        imgui.backends.opengl3_new_frame()
        imgui.backends.glfw_new_frame()
        imgui.new_frame()
        if self._ink is None:
            self._ink = Ink(self.fonts, self._scale)
        self._ink.begin()
        self.hud.draw(self._ink, view, self.shown, size)
        self.depth.draw(view, self.shown, size)
        self.plots.draw(self.shown, size, self._ink.em)
        self.panel.draw(view, self.shown, size)
        self.menu.draw(view, self.shown, size)
        draw_help(view, self.shown, self.fonts, size)
        imgui.render()
        self.plots.paint(self.shown)
        imgui.backends.opengl3_render_draw_data(imgui.get_draw_data())

    def close(self) -> None:
        """Give back everything; the window must still be there. Calling it twice is harmless."""
        if self._closed:
            return
        self._closed = True
        self._make_current()
        self.depth.close()
        self.plots.close()
        imgui.backends.opengl3_shutdown()
        imgui.backends.glfw_shutdown()
        imgui.destroy_context(self._context)

    def _make_current(self) -> None:
        imgui.set_current_context(self._context)

    def _navigate(self, on: bool) -> None:
        """Arrow keys and gamepad walk through the menu; elsewhere they belong to the game."""
        io = imgui.get_io()
        flags = imgui.ConfigFlags_.nav_enable_keyboard | imgui.ConfigFlags_.nav_enable_gamepad
        io.config_flags = io.config_flags | flags if on else io.config_flags & ~flags

    def _rescale(self) -> None:
        height = glfw.get_framebuffer_size(self._handle)[1]
        units = max(1, glfw.get_window_size(self._handle)[1])
        scale = interface_scale(height, glfw.get_window_content_scale(self._handle)[0]) * units / max(1, height)
        if abs(scale - self._scale) > 1e-3:
            self._scale, self._ink = scale, None
            apply_style(scale)
