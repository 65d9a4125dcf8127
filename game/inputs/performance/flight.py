"""The upper body's share of a jump: without a floor to push on, the angular momentum cannot change.

As the knees extend and the feet tuck, the upper body pitches the other way: an offset theta to its pitch with
I theta'' = -(rate of the rest of the body's angular momentum about the centre of mass) in flight, and a return to the script's
pitch at RETURN_RAD_S on the floor. The two blend with the ground force, in one tridiagonal system in time.
"""

import numpy as np

from game.inputs.performance.balance import GRAVITY, ground_force, second_difference
from game.inputs.performance.curves import ease
from game.inputs.performance.person import MASS_KG, POINT_MASSES_KG, POINT_WEIGHTS, centre_of_mass, point_masses
from game.inputs.performance.tridiagonal import solve_tridiagonal
from kinect.body import Floats, Joint

RETURN_RAD_S = 7.0
_UPPER = (POINT_WEIGHTS[:, [Joint.KNEE_LEFT, Joint.ANKLE_LEFT, Joint.KNEE_RIGHT, Joint.ANKLE_RIGHT]] == 0.0).all(axis=1)


def pitch_momentum_rate(joints: Floats, step_s: float) -> Floats:
    """(T,) rate of the angular momentum about the centre of mass, y component, kg m2/s2, of (T, 20, 3) world joints."""
    points = point_masses(joints)
    arm = points - centre_of_mass(joints)[:, None]
    pull = second_difference(points, step_s)
    return (arm[..., 2] * pull[..., 0] - arm[..., 0] * pull[..., 2]) @ POINT_MASSES_KG


def counter_pitch(joints: Floats, pitch: Floats, step_s: float) -> Floats:
    """(T,) the upper body's pitch offset, radians, that takes over from pitch (T,), with which the joints (T, 20, 3) were posed."""
    points = point_masses(joints)
    arm = (points - centre_of_mass(joints)[:, None])[:, _UPPER]
    lever = (points - joints[:, None, Joint.HIP_CENTER])[:, _UPPER]
    inertia = (arm[..., 0] * lever[..., 0] + arm[..., 2] * lever[..., 2]) @ POINT_MASSES_KG[_UPPER]
    rest = pitch_momentum_rate(joints, step_s) / inertia - second_difference(pitch, step_s)
    grip = ease(ground_force(joints, step_s) / (MASS_KG * GRAVITY), 0.0, 0.6)
    side = np.full(len(pitch), -1.0 / step_s**2)
    side[0] = side[-1] = 0.0
    diagonal = RETURN_RAD_S**2 * grip - 2.0 * side + np.where(side == 0.0, 1.0, 0.0)
    right = (1.0 - grip) * rest
    right[0] = right[-1] = 0.0
    return solve_tridiagonal(side, diagonal, side, right[:, None])[:, 0]
