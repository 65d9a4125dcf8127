"""What each joint and the pelvis are asked to do: accelerations that bring them to the target's motion."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.compiled import compiled

Floats = NDArray[np.float64]


LARGEST_SPIN, LARGEST_SPIN_RATE = 15.0, 120.0
"""rad/s and rad/s^2; what turns faster than that in the target is the sensor."""


@compiled
def turn_error(now: Floats, wanted: Floats) -> Floats:
    """(3,) rad, the rotation vector from `now` (4,) to `wanted` (4,), in the frame of `now`."""
    out = np.empty(3)
    out[0], out[1], out[2] = one.turn_to(now, wanted)
    return out


@compiled
def joint_accelerations(
    error: Floats, velocity: Floats, spin: Floats, spin_rate: Floats, stiffness: float, damping: float, limit: Floats
) -> Floats:
    """(42,) rad/s^2, child frames: stiffness times error, damping times the error's rate, and the target's own acceleration.

    error, velocity, limit (42,); spin, spin_rate (14 or more, 3).
    """
    out = np.empty(len(error))
    for row in range(len(error)):
        j, axis = row // 3, row % 3
        rate = min(max(spin[j, axis], -LARGEST_SPIN), LARGEST_SPIN)
        surge = min(max(spin_rate[j, axis], -LARGEST_SPIN_RATE), LARGEST_SPIN_RATE)
        value = stiffness * error[row] + damping * (rate - velocity[row]) + surge
        out[row] = min(max(value, -limit[row]), limit[row])
    return out


@compiled
def turn_acceleration(error: Floats, spin: Floats, wanted_spin: Floats, stiffness: float, damping: float, limit: float) -> Floats:
    """(3,) rad/s^2 in a body's frame, from its rotation vector `error` (3,) to where it is wanted; spins (3,) in their own frames."""
    out = stiffness * error + damping * (wanted_spin - spin)
    size = one.length(out)
    return out * min(1.0, limit / max(size, 1e-9))


@compiled
def way_back(error: Floats, root_error: Floats, rate: float, largest: float) -> Floats:
    """(48,) rad/s at which pelvis and joints would come to the target's pose at `rate` (1/s), no axis faster than `largest`.

    error (42,) of the joints, root_error (3,) of the pelvis, which goes nowhere.
    """
    out = np.zeros(6 + len(error))
    out[3:6], out[6:] = root_error, error
    return np.minimum(np.maximum(rate * out, -largest), largest)
