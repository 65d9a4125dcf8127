"""The path of the pelvis that keeps the ground force where the script wants it.

The person is a set of point masses m_i at r_i. With p the zero moment point on the floor, the moment of gravity and inertia about p
has no horizontal part:  sum m_i [(z''_i + g)(x_i - p) - z_i x''_i] = 0, and likewise for y (Vukobratovic & Borovac 2004).
Moving the pelvis by d changes the left side by about F d - S d'', F = sum m (z'' + g), S = sum m z: one tridiagonal system in time.
Newton steps with it converge because only the legs follow the pelvis by less than the full distance.
In flight only the centre of mass can be held: it keeps its horizontal velocity.
"""

import numpy as np

from game.inputs.performance.figure import Figure
from game.inputs.performance.person import MASS_KG, POINT_MASSES_KG, point_masses
from game.inputs.performance.tridiagonal import solve_tridiagonal
from kinect.body import Floats

GRAVITY: float = 9.81


def second_difference(values: Floats, step_s: float) -> Floats:
    """(T, ...) central second derivative along time; zero at both ends, where the person stands still."""
    result = np.zeros_like(values)
    result[1:-1] = (values[2:] - 2.0 * values[1:-1] + values[:-2]) / step_s**2
    return result


def ground_force(joints: Floats, step_s: float) -> Floats:
    """(T,) vertical ground force, newtons, of (T, 20, 3) world joints step_s apart."""
    lift = second_difference(point_masses(joints)[..., 2], step_s) + GRAVITY
    return lift @ POINT_MASSES_KG


def zero_moment_point(joints: Floats, step_s: float) -> Floats:
    """(T, 2) zero moment point on the floor, metres, of (T, 20, 3) world joints step_s apart; NaN without ground force."""
    points = point_masses(joints)
    pull = second_difference(points, step_s)
    weight = (pull[..., 2] + GRAVITY) * POINT_MASSES_KG
    height = POINT_MASSES_KG * points[..., 2]
    moment = np.einsum("tp,tpk->tk", weight, points[..., :2]) - np.einsum("tp,tpk->tk", height, pull[..., :2])
    force = np.sum(weight, axis=1)
    return moment / np.where(force > 1e-6 * MASS_KG, force, np.nan)[:, None]


def solve_pelvis_path(
    figure: Figure,
    zmp: Floats,
    com_rise: Floats | None,
    airborne: np.ndarray,
    step_s: float,
    rounds: int,
    start: Floats | None = None,
) -> Floats:
    """(T, 3) world path of HIP_CENTER, metres.

    zmp: (T, 2) wanted zero moment point, metres. com_rise: (T,) height of the centre of mass above that of the first sample,
    metres, or None to keep the figure's pelvis height. airborne: (T,) True where both feet are off the floor.
    rounds: how many Newton steps; each leaves about a fifth of the error. start: (T, 3) a path near the solution, if one is known.
    """
    pelvis = np.column_stack([zmp, figure.pelvis_height]) if start is None else start.copy()
    for _ in range(rounds):
        points = point_masses(figure.joints(pelvis))
        if com_rise is not None:
            height = points[..., 2] @ POINT_MASSES_KG / MASS_KG
            pelvis[:, 2] += com_rise - (height - height[0])
        pelvis[:, :2] += _correction(points, zmp, airborne, step_s)
    return pelvis


def _correction(points: Floats, zmp: Floats, airborne: np.ndarray, step_s: float) -> Floats:
    pull = second_difference(points, step_s)
    weight = (pull[..., 2] + GRAVITY) * POINT_MASSES_KG
    height = POINT_MASSES_KG * points[..., 2]
    force, inertia = np.sum(weight, axis=1), np.sum(height, axis=1)
    moment = np.einsum("tp,tpk->tk", weight, points[..., :2]) - np.einsum("tp,tpk->tk", height, pull[..., :2]) - force[:, None] * zmp
    drift = np.tensordot(pull[..., :2], POINT_MASSES_KG / MASS_KG, axes=(1, 0))
    moment = np.where(airborne[:, None], -inertia[:, None] * drift, moment)
    force = np.where(airborne, 0.0, np.maximum(force, 0.0))
    side = -inertia / step_s**2
    side[0] = side[-1] = 0.0
    return solve_tridiagonal(side, force - 2.0 * side, side, -moment)
