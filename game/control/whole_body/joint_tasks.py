"""What each joint and the pelvis are asked to do: accelerations that bring them to the target's motion."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.compiled import compiled

Floats = NDArray[np.float64]


LARGEST_SPIN, LARGEST_SPIN_RATE = 15.0, 120.0
"""rad/s and rad/s^2; what turns faster than that in the target is the sensor."""


@compiled
def joint_accelerations(
    now: Floats, velocity: Floats, wanted: Floats, spin: Floats, spin_rate: Floats, stiffness: float, damping: float, limit: Floats
) -> Floats:
    """(42,) rad/s^2, child frames: stiffness times error, damping times the error's rate, and the target's own acceleration.

    now, wanted (14, 4); velocity (42,), limit (42,); spin, spin_rate (14, 3).
    """
    out = np.empty(3 * len(now))
    for j in range(len(now)):
        error = one.log(one.multiply(one.conjugate(now[j]), wanted[j]))
        for axis in range(3):
            row = 3 * j + axis
            rate = min(max(spin[j, axis], -LARGEST_SPIN), LARGEST_SPIN)
            surge = min(max(spin_rate[j, axis], -LARGEST_SPIN_RATE), LARGEST_SPIN_RATE)
            value = stiffness * error[axis] + damping * (rate - velocity[row]) + surge
            out[row] = min(max(value, -limit[row]), limit[row])
    return out


@compiled
def turn_acceleration(
    now: Floats, spin: Floats, wanted: Floats, wanted_spin: Floats, stiffness: float, damping: float, limit: float
) -> Floats:
    """(3,) rad/s^2 in the frame of `now` (4,): towards `wanted` (4,); spins (3,) in the frames they belong to."""
    error = one.log(one.multiply(one.conjugate(now), wanted))
    out = stiffness * error + damping * (wanted_spin - spin)
    size = one.length(out)
    return out * min(1.0, limit / max(size, 1e-9))


@compiled
def way_back(rotation: Floats, orientation: Floats, wanted: Floats, upright: Floats, rate: float, largest: float) -> Floats:
    """(48,) rad/s at which pelvis and joints would come to the target's pose at `rate` (1/s), no axis faster than `largest`.

    rotation, wanted (14, 4); orientation, upright (4,) of the pelvis. The pelvis goes nowhere.
    """
    count = len(rotation)
    out = np.zeros(6 + 3 * count)
    for j in range(count + 1):
        if j < count:
            first, error = 6 + 3 * j, one.log(one.multiply(one.conjugate(rotation[j]), wanted[j]))
        else:
            first, error = 3, one.log(one.multiply(one.conjugate(orientation), upright))
        for axis in range(3):
            out[first + axis] = min(max(rate * error[axis], -largest), largest)
    return out
