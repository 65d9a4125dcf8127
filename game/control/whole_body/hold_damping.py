"""How firmly joints are held to their planned speed between two ticks: no firmer than their strength has room for."""

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled

Floats = NDArray[np.float64]

SPARE_RAD_S = 5.0
"""So far off its planned speed a joint may be thrown before the hold and the torque together take all its strength."""

MIDDLE = 0.56
"""Share of a tick after which the damping meets the velocity that it is to hold: the middle of the steps it acts in."""

LARGEST_CHANGE_RAD_S, FASTEST_RAD_S = 5.0, 25.0
"""What a joint is planned to gain in half a tick at most, and how fast a hold lets it be."""


@compiled
def hold_damping(wanted: Floats, torque: Floats, low: Floats, high: Floats) -> Floats:
    """(42,) N m s/rad: `wanted` (42,), less where torque (42,) leaves little room between low and high (42,); none where it leaves none."""
    out = np.empty(len(wanted))
    for i in range(len(wanted)):
        room = max(min(high[i] - torque[i], torque[i] - low[i]), 0.0)
        out[i] = min(wanted[i], room / SPARE_RAD_S)
    return out


@compiled
def hold(
    firmness: Floats, torque: Floats, low: Floats, high: Floats, velocity: Floats, acceleration: Floats, dt: float,
    damping: Floats, speed: Floats,
) -> None:  # fmt: skip
    """Fill damping N m s/rad and speed rad/s, (42,) each, that hold the joints to their plan for `dt`; velocity, acceleration (48,)."""
    damping[:] = hold_damping(firmness, torque, low, high)
    speed[:] = held_speed(velocity[6:], MIDDLE * dt * acceleration[6:])


@compiled
def held_speed(velocity: Floats, gain: Floats) -> Floats:
    """(42,) rad/s that the joints are held to: velocity (42,) and what it should gain (42,), both within bounds.

    Where torques ran into their limits the planned acceleration is none that could be; holding to it would whirl a light limb.
    """
    out = np.empty(len(velocity))
    for i in range(len(velocity)):
        wanted = min(max(velocity[i] + gain[i], -FASTEST_RAD_S), FASTEST_RAD_S)
        out[i] = min(max(wanted, velocity[i] - LARGEST_CHANGE_RAD_S), velocity[i] + LARGEST_CHANGE_RAD_S)
    return out
