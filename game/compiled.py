"""The decorator of every compiled loop: numba in nopython mode, cached on disk, IEEE arithmetic in the order it is written.

Small arrays cost numpy more in calls than in sums. What runs hundreds of times a second is therefore written as plain loops
and compiled; the first start compiles for a few seconds, later ones load the cache.
"""

from collections.abc import Callable
from typing import Any, TypeVar

import numba

Function = TypeVar("Function", bound=Callable[..., Any])


def compiled(function: Function) -> Function:
    """`function` compiled at its first call for the types it is given; no fast-math, so results repeat bit by bit."""
    return numba.njit(cache=True, error_model="numpy")(function)  # type: ignore[return-value]
