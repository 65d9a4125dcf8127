"""The last frames of the target as one smooth motion: position, velocity and acceleration at any moment of the window.

A quadratic is fitted to the last frames in the tangent space of the middle one. Evaluated `delay` behind the newest frame
it gives the pose with little noise; the newest frames themselves tell balance, ahead of time, where the weight is going.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import FEET, JOINT_COUNT
from game.compiled import compiled
from game.target.kinematic_target import KinematicTarget

Floats = NDArray[np.float64]

FRAMES = 9
"""At most so many frames are kept; how many count is a matter of time."""

_ROOT = JOINT_COUNT
_TURNS, _PLACES = JOINT_COUNT + 3, 4
_COM = 3


class Motion(NamedTuple):
    """A moment of the target's motion, in the player's world frame.

    turn (17, 4): fourteen joints (child in parent), the root, left and right foot (world); spin, spin_rate (17, 3) in the turned
    frame; place, velocity, acceleration (4, 3): root, left and right ankle, COM.
    """

    turn: Floats
    spin: Floats
    spin_rate: Floats
    place: Floats
    velocity: Floats
    acceleration: Floats

    @property
    def joint(self) -> Floats:
        return self.turn[:JOINT_COUNT]

    @property
    def root(self) -> Floats:
        return self.turn[_ROOT]


MotionFields = tuple[Floats, ...]
"""A `Motion` as compiled code takes it: numba takes a plain tuple much faster than one with names."""


class MotionWindow:
    """Keeps the last frames; `add` a frame when it comes, ask for a `moment` whenever control needs one."""

    def __init__(self) -> None:
        self._count = 0
        self._times, self._turns, self._places = np.zeros(FRAMES), np.zeros((FRAMES, _TURNS, 4)), np.zeros((FRAMES, _PLACES, 3))
        self._middle, self._turn_terms, self._place_terms = np.zeros((_TURNS, 4)), np.zeros((_TURNS, 3, 3)), np.zeros((_PLACES, 3, 3))
        self._com_velocity = np.zeros(3)
        self._rise = (0.0, 0.0)

    @property
    def newest_s(self) -> float:
        return float(self._times[self._count - 1])

    @property
    def newest_places(self) -> Floats:
        """(4, 3) root, ankles, COM of the newest frame."""
        return self._places[self._count - 1]

    def add(self, target: KinematicTarget, span_s: float) -> None:
        """Take a frame in; frames older than `span_s` before it are forgotten, but three are always kept where there are three."""
        pose = target.pose
        self._count, self._rise = _take(
            self._times, self._turns, self._places, self._count, span_s, target.time_s, target.joint_rotation, target.root_orientation,
            pose.orientation, target.root_position, pose.joint, target.com, self._middle, self._turn_terms, self._place_terms,
            self._com_velocity,
        )  # fmt: skip

    def moment(self, time_s: float) -> Motion:
        """The motion at `time_s`, held within the window."""
        last, times = self._count - 1, self._times
        since = min(max(time_s, float(times[0])), float(times[last]) + 0.5 / 30.0) - float(times[last // 2])
        # made here and filled there: handing arrays out of compiled code costs more than this
        turn, spin, spin_rate = np.empty((_TURNS, 4)), np.empty((_TURNS, 3)), np.empty((_TURNS, 3))
        place, velocity, acceleration = np.empty((_PLACES, 3)), np.empty((_PLACES, 3)), np.empty((_PLACES, 3))
        _evaluate(self._middle, self._turn_terms, self._place_terms, since, turn, spin, spin_rate, place, velocity, acceleration)
        return Motion(turn, spin, spin_rate, place, velocity, acceleration)

    def com_velocity(self) -> Floats:
        """(3,) m/s of the COM over the window, by a straight line: less noisy at its end than the parabola."""
        return self._com_velocity

    @property
    def newest_rise(self) -> tuple[float, float]:
        """Height (m) and upward speed (m/s) of the COM in the `moment` of the newest frame."""
        return self._rise


@compiled
def _take(
    times: Floats, turns: Floats, places: Floats, count: int, span_s: float, time_s: float, joint_rotation: Floats,
    root_orientation: Floats, orientation: Floats, root_position: Floats, joint: Floats, com: Floats, middle: Floats, turn_terms: Floats,
    place_terms: Floats, com_velocity: Floats,
) -> tuple[int, tuple[float, float]]:  # fmt: skip
    """Put a frame behind the `count` first ones, drop the old ones from the front, `_fit` and `_slope`; gives how many there are and the
    COM's rise in the newest."""
    if count > 0 and time_s <= times[count - 1]:
        count = 0
    drop = 1 if count == FRAMES else 0
    while count - drop >= 3 and times[drop] < time_s - span_s - 1e-6:
        drop += 1
    count -= drop
    for k in range(count):
        times[k], turns[k], places[k] = times[k + drop], turns[k + drop], places[k + drop]
    times[count] = time_s
    turns[count, :JOINT_COUNT], turns[count, JOINT_COUNT] = joint_rotation, root_orientation
    places[count, 0], places[count, _COM] = root_position, com
    for side in range(2):
        turns[count, JOINT_COUNT + 1 + side] = orientation[FEET[side]]
        places[count, 1 + side] = joint[FEET[side]]
    count += 1
    _fit(times[:count], turns[:count], places[:count], middle, turn_terms, place_terms)
    com_velocity[:] = _slope(times[:count], places[:count])
    since, com = times[count - 1] - times[(count - 1) // 2], place_terms[_COM]
    rise = com[0, 2] + since * com[1, 2] + 0.5 * since * since * com[2, 2], com[1, 2] + since * com[2, 2]
    return count, rise


@compiled
def _slope(times: Floats, places: Floats) -> Floats:
    """(3,) m/s of the COM's straight line through (n, m, 3) places."""
    count = len(times)
    middle = 0.0
    for k in range(count):
        middle += times[k] / count
    out, total = np.zeros(3), 0.0
    for k in range(count):
        away = times[k] - middle
        total += away * away
        for axis in range(3):
            out[axis] += away * places[k, _COM, axis]
    return out / total if total > 0.0 else out


@compiled
def _solve_quadratic(times: Floats) -> Floats:
    """(3, n): the least-squares coefficients (1, t, t^2 / 2) of values at n times; lower orders where there are too few."""
    count = len(times)
    order = min(count, 3)
    basis = np.zeros((count, order))
    for k in range(count):
        basis[k, 0] = 1.0
        if order > 1:
            basis[k, 1] = times[k]
        if order > 2:
            basis[k, 2] = 0.5 * times[k] * times[k]
    # modified Gram-Schmidt: basis = q r
    q, r = basis.copy(), np.zeros((order, order))
    for j in range(order):
        for i in range(j):
            for k in range(count):
                r[i, j] += q[k, i] * q[k, j]
            for k in range(count):
                q[k, j] -= r[i, j] * q[k, i]
        total = 0.0
        for k in range(count):
            total += q[k, j] * q[k, j]
        r[j, j] = np.sqrt(total)
        for k in range(count):
            q[k, j] /= r[j, j]
    out = np.zeros((3, count))
    for k in range(count):
        for i in range(order - 1, -1, -1):
            value = q[k, i]
            for j in range(i + 1, order):
                value -= r[i, j] * out[j, k]
            out[i, k] = value / r[i, i]
    return out


@compiled
def _fit(times: Floats, turns: Floats, places: Floats, middle: Floats, turn_terms: Floats, place_terms: Floats) -> None:
    """Fill middle turns (n, 4); terms of the tangent rotation (n, 3, 3) and of the places (m, 3, 3): order, axis."""
    count = len(times)
    middle_at = (count - 1) // 2
    solve = _solve_quadratic(times - times[middle_at])
    middle[:] = turns[middle_at]
    turn_terms[:] = 0.0
    place_terms[:] = 0.0
    for k in range(count):
        for n in range(turns.shape[1]):
            x, y, z = one.turn_to(middle[n], turns[k, n])
            for order in range(3):
                turn_terms[n, order, 0] += solve[order, k] * x
                turn_terms[n, order, 1] += solve[order, k] * y
                turn_terms[n, order, 2] += solve[order, k] * z
        for n in range(places.shape[1]):
            for order in range(3):
                for axis in range(3):
                    place_terms[n, order, axis] += solve[order, k] * places[k, n, axis]


@compiled
def _evaluate(
    middle: Floats, turn_terms: Floats, place_terms: Floats, t: float, turn: Floats, spin: Floats, spin_rate: Floats, place: Floats,
    velocity: Floats, acceleration: Floats,
) -> None:  # fmt: skip
    """Fill the fields of a `Motion` with what the terms of `_fit` give at `t` seconds from the middle frame."""
    away = np.empty(3)
    for n in range(len(turn_terms)):
        for axis in range(3):
            rest, slope, bend = turn_terms[n, 0, axis], turn_terms[n, 1, axis], turn_terms[n, 2, axis]
            away[axis] = rest + t * slope + 0.5 * t * t * bend
            spin[n, axis], spin_rate[n, axis] = slope + t * bend, bend
        turn[n] = one.multiply(middle[n], one.exp(away))
    for n in range(len(place_terms)):
        for axis in range(3):
            rest, slope, bend = place_terms[n, 0, axis], place_terms[n, 1, axis], place_terms[n, 2, axis]
            place[n, axis] = rest + t * slope + 0.5 * t * t * bend
            velocity[n, axis], acceleration[n, axis] = slope + t * bend, bend
