"""Opens something to draw into: a window, a window on no display (GLFW's null platform with EGL), or plain memory (OSMesa)."""

import os
import sys
import warnings
from dataclasses import dataclass, field
from typing import Any

import moderngl

from game.render.osmesa import OSMesaContext, OSMesaMissing

_REMEDY = "On Debian or Ubuntu: apt install libegl1 libgl1; or run with --no-draw."
_open_windows = 0


class NoPicture(RuntimeError):
    """Nothing can be drawn on this machine; the message is one sentence with the cause and one with the remedy."""


@dataclass
class GLWindow:
    """An OpenGL 3.3 core context with a default framebuffer. kind: "window", "egl" (no display) or "osmesa" (no display, no EGL).

    handle: the GLFW window, None for "osmesa".
    """

    ctx: moderngl.Context
    kind: str
    handle: Any = None
    memory: OSMesaContext | None = None
    _closing: bool = field(default=False, repr=False)

    @property
    def framebuffer_size(self) -> tuple[int, int]:
        """(width, height) in pixels; follows the window."""
        if self.memory is not None:
            return self.memory.size
        import glfw

        return glfw.get_framebuffer_size(self.handle)

    @property
    def content_scale(self) -> float:
        """Pixels per point of text: 1 on an ordinary screen, 2 on a typical HiDPI one."""
        if self.handle is None:
            return 1.0
        import glfw

        return float(glfw.get_window_content_scale(self.handle)[0])

    @property
    def screen(self) -> moderngl.Framebuffer:
        """The default framebuffer, with its viewport over the whole of it."""
        self.ctx.screen.viewport = (0, 0, *self.framebuffer_size)
        return self.ctx.screen

    @property
    def should_close(self) -> bool:
        """True once the player closed the window or `ask_to_close` was called."""
        if self.handle is None:
            return self._closing
        import glfw

        return self._closing or bool(glfw.window_should_close(self.handle))

    def ask_to_close(self) -> None:
        self._closing = True

    def poll_events(self) -> None:
        """Deliver keys, mouse and resizes to the callbacks."""
        if self.handle is not None:
            import glfw

            glfw.poll_events()

    def swap(self) -> None:
        """Show the finished picture."""
        if self.handle is None:
            self.ctx.finish()
        else:
            import glfw

            glfw.swap_buffers(self.handle)

    def make_current(self) -> None:
        """Let OpenGL calls go here again after another window was opened or closed."""
        if self.handle is not None:
            import glfw

            # EGL takes the same context again for no change, though OSMesa may have had the calls meanwhile
            glfw.make_context_current(None)  # pyright: ignore[reportArgumentType]  None is what GLFW documents
            glfw.make_context_current(self.handle)

    def close(self) -> None:
        """Give everything back; calling it twice is harmless."""
        global _open_windows
        if self.handle is not None:
            import glfw

            self.ctx.release()
            glfw.destroy_window(self.handle)
            self.handle = None
            _open_windows -= 1
            if _open_windows == 0:
                glfw.terminate()
        if self.memory is not None:
            self.ctx.release()
            self.memory.release()


def open_gl(width: int, height: int, title: str, *, headless: bool, samples: int = 0, vsync: bool = True) -> GLWindow:
    """Open a window, or with `headless` the same without a display. width, height: points (pixels when headless).

    The environment variable TOPPLE_GL (egl or osmesa) forces one of the two headless ways. Raises NoPicture.
    """
    forced = os.environ.get("TOPPLE_GL", "")
    if forced not in ("", "egl", "osmesa"):
        raise NoPicture(f"TOPPLE_GL is {forced!r}; valid: egl, osmesa, or leave it unset.")
    if not headless:
        return _open_glfw(width, height, title, headless=False, samples=samples, vsync=vsync)
    if forced == "osmesa":
        return _open_osmesa(width, height)
    try:
        return _open_glfw(width, height, title, headless=True, samples=samples, vsync=False)
    except NoPicture as no_egl:
        if forced == "egl" or not sys.platform.startswith("linux"):
            raise
        try:
            return _open_osmesa(width, height)
        except NoPicture:
            raise no_egl from None


def _open_osmesa(width: int, height: int) -> GLWindow:
    try:
        memory = OSMesaContext(width, height)
    except OSMesaMissing as missing:
        raise NoPicture(str(missing)) from None
    foreign: Any = memory
    ctx = moderngl.create_context(require=330, context=foreign)
    return GLWindow(ctx, "osmesa", memory=memory)


def _open_glfw(width: int, height: int, title: str, *, headless: bool, samples: int, vsync: bool) -> GLWindow:
    global _open_windows
    glfw = _import_glfw()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # pyGLFW warns on each failure; NoPicture says it once
        glfw.init_hint(glfw.PLATFORM, glfw.PLATFORM_NULL if headless else glfw.ANY_PLATFORM)
        if not glfw.init():
            raise NoPicture(f"No window can be opened ({_last_error(glfw)}). Without a display run with --headless.")
        if headless != (glfw.get_platform() == glfw.PLATFORM_NULL):
            raise NoPicture("A window with and a window without a display cannot be open at once; close the first one first.")
        _hint(glfw, headless, samples)
        handle = glfw.create_window(width, height, title, None, None)
        if not handle:
            reason = _last_error(glfw)
            if _open_windows == 0:
                glfw.terminate()
            raise NoPicture(f"There is no OpenGL 3.3 here ({reason}). {_REMEDY}")
    _open_windows += 1
    glfw.make_context_current(handle)
    glfw.swap_interval(1 if vsync else 0)
    try:
        ctx = _context_of_the_window()
    except Exception as broken:
        glfw.destroy_window(handle)
        _open_windows -= 1
        raise NoPicture(f"There is no OpenGL 3.3 here ({broken}). {_REMEDY}") from broken
    return GLWindow(ctx, "egl" if headless else "window", handle)


def _context_of_the_window() -> moderngl.Context:
    # create_context() looks for EGL only in the first context of a process, and for nothing but GLX in later ones
    moderngl.init_context()
    ctx = moderngl.get_context()
    if ctx.version_code < 330:
        raise RuntimeError(f"only OpenGL {ctx.version_code / 100:.1f}")
    return ctx


def _hint(glfw: Any, headless: bool, samples: int) -> None:
    glfw.default_window_hints()
    glfw.window_hint(glfw.CONTEXT_CREATION_API, glfw.EGL_CONTEXT_API if headless else glfw.NATIVE_CONTEXT_API)
    glfw.window_hint(glfw.CONTEXT_VERSION_MAJOR, 3)
    glfw.window_hint(glfw.CONTEXT_VERSION_MINOR, 3)
    glfw.window_hint(glfw.OPENGL_PROFILE, glfw.OPENGL_CORE_PROFILE)
    glfw.window_hint(glfw.OPENGL_FORWARD_COMPAT, True)  # macOS gives a core profile only so
    glfw.window_hint(glfw.SCALE_TO_MONITOR, not headless)
    glfw.window_hint(glfw.SAMPLES, samples)


def _import_glfw() -> Any:
    try:
        import glfw
    except ImportError as missing:
        raise NoPicture(f"GLFW cannot be loaded ({missing}). {_REMEDY}") from missing
    wanted = os.environ.get("PYGLFW_LIBRARY", "")
    library = getattr(glfw, "_glfw", None)
    loaded = getattr(library, "_name", None)
    if wanted and loaded is not None and os.path.realpath(loaded) != os.path.realpath(wanted):
        raise NoPicture("glfw was imported before game and brought a GLFW that cannot draw without a display; import game first.")
    return glfw


def _last_error(glfw: Any) -> str:
    code, text = glfw.get_error()
    if not code or text is None:
        return "GLFW gives no reason"
    return text.decode(errors="replace") if isinstance(text, bytes) else str(text)
