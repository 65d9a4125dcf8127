"""An OpenGL context that Mesa draws into plain memory (libOSMesa), for machines that have no EGL."""

import ctypes
import ctypes.util
from typing import Any

_DEPTH_BITS, _STENCIL_BITS, _PROFILE, _CORE_PROFILE = 0x30, 0x31, 0x33, 0x34
_FORMAT, _MAJOR, _MINOR = 0x22, 0x36, 0x37
_RGBA, _UNSIGNED_BYTE = 0x1908, 0x1401


class OSMesaMissing(RuntimeError):
    """libOSMesa is not installed or gives no OpenGL 3.3; the message is one sentence."""


class OSMesaContext:
    """A current OSMesa context of OpenGL 3.3 core with a default framebuffer of (width, height) pixels.

    It has the `load` that moderngl asks of a foreign context. Raises OSMesaMissing.
    """

    def __init__(self, width: int, height: int) -> None:
        self.size = (width, height)
        self._library = _load_library()
        wanted = (_FORMAT, _RGBA, _DEPTH_BITS, 24, _STENCIL_BITS, 8, _PROFILE, _CORE_PROFILE, _MAJOR, 3, _MINOR, 3, 0)
        self._context = self._library.OSMesaCreateContextAttribs((ctypes.c_int * len(wanted))(*wanted), None)
        if not self._context:
            raise OSMesaMissing("libOSMesa is too old for OpenGL 3.3; install libosmesa6 of a current distribution.")
        self._pixels = ctypes.create_string_buffer(width * height * 4)
        self._make_current()

    def _make_current(self) -> None:
        if not self._library.OSMesaMakeCurrent(self._context, self._pixels, _UNSIGNED_BYTE, *self.size):
            raise OSMesaMissing(f"libOSMesa cannot draw {self.size[0]} x {self.size[1]} pixels; ask for a smaller picture.")

    def load(self, name: str) -> int:
        """Address of an OpenGL function, 0 where there is none."""
        return self._library.OSMesaGetProcAddress(name.encode()) or 0

    def __enter__(self) -> "OSMesaContext":
        self._make_current()
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def release(self) -> None:
        """Free the context; calling it twice is harmless."""
        if self._context:
            self._library.OSMesaDestroyContext(self._context)
            self._context = None


def _load_library() -> Any:
    for name in (ctypes.util.find_library("OSMesa"), "libOSMesa.so.8", "libOSMesa.so.6"):
        try:
            library = ctypes.CDLL(name) if name else None
        except OSError:
            continue
        if library is None:
            continue
        library.OSMesaCreateContextAttribs.restype = ctypes.c_void_p
        library.OSMesaCreateContextAttribs.argtypes = [ctypes.POINTER(ctypes.c_int), ctypes.c_void_p]
        library.OSMesaMakeCurrent.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint, ctypes.c_int, ctypes.c_int]
        library.OSMesaGetProcAddress.restype = ctypes.c_void_p
        library.OSMesaGetProcAddress.argtypes = [ctypes.c_char_p]
        library.OSMesaDestroyContext.argtypes = [ctypes.c_void_p]
        return library
    raise OSMesaMissing("libOSMesa is not installed (Debian: apt install libosmesa6).")
