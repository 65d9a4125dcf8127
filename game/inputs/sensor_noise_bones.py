"""Bones that change their length with the pose, as the sensor's skeleton does: slowly, and the same again in the same pose.

A bone's error is a smooth random function of the whole pose, most of all of its own direction, so a body that
rests keeps its (wrong) lengths and a body that moves shows the spread of `BONE_CV`.
"""

import math
from typing import Final

import numpy as np

from game.compiled import compiled
from game.definite_system import solve_definite
from game.inputs.sensor_noise_table import BONE_CV
from kinect.body import BONES, JOINT_COUNT, Floats, Joint

_WAVES: Final = 8  # cosines a bone; more make the error's distribution more Gaussian
_WAVE_SIZE: Final = math.sqrt(2.0 / _WAVES)
_OWN: Final = 2.5  # radians of phase a unit change of the bone's own direction brings
_OTHERS: Final = 0.8
_LARGEST: Final = 0.7  # a bone never loses or gains more than this share
_PARENT: Final = np.array([parent for parent, _ in BONES])
_CHILD: Final = np.array([child for _, child in BONES])
_INCIDENCE: Final = np.zeros((len(BONES), JOINT_COUNT))
_INCIDENCE[np.arange(len(BONES)), _CHILD] = 1.0
_INCIDENCE[np.arange(len(BONES)), _PARENT] = -1.0

# spread over BONE_CV, solved so that the performer's eight motions show BONE_CV in the median: no motion visits every pose
_ARM: Final = (1.82, 1.74, 1.66, 1.66)
_LEG: Final = (1.68, 1.51, 1.62, 1.85)
_GAIN: Final[Floats] = np.array([1.44, 1.57, 1.79, *_ARM, *_ARM, *_LEG, *_LEG])  # in the order of BONES


def _mobility() -> Floats:
    """How readily the sensor misplaces each joint, (20,): seen ankles stay put, hands go anywhere."""
    mobility = np.ones(JOINT_COUNT)
    for joints, value in (
        ((Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT), 0.15),
        ((Joint.ELBOW_LEFT, Joint.ELBOW_RIGHT), 2.0),
        ((Joint.WRIST_LEFT, Joint.WRIST_RIGHT), 3.0),
        ((Joint.HAND_LEFT, Joint.HAND_RIGHT), 8.0),
        ((Joint.FOOT_LEFT, Joint.FOOT_RIGHT), 3.0),
    ):
        mobility[list(joints)] = value
    return mobility


_MOBILITY: Final[Floats] = _mobility()
_COUPLING: Final[Floats] = (_INCIDENCE * _MOBILITY) @ _INCIDENCE.T

_RIDGE: Final[Floats] = 1e-9 * np.eye(len(BONES))
_SPREAD: Final[Floats] = BONE_CV * _GAIN


@compiled
def _directions_and_lengths(positions: Floats) -> tuple[Floats, Floats]:
    """Unit directions (19, 3) and lengths (19,) m of the bones between joints (20, 3); a bone with a lost end has none."""
    directions, lengths = np.zeros((len(_CHILD), 3)), np.zeros(len(_CHILD))
    for bone in range(len(_CHILD)):
        x, y, z = positions[_CHILD[bone]] - positions[_PARENT[bone]]
        length = math.sqrt(x * x + y * y + z * z)
        if math.isfinite(length):
            lengths[bone], least = length, max(length, 1e-6)
            directions[bone, 0], directions[bone, 1], directions[bone, 2] = x / least, y / least, z / least
    return directions, lengths


@compiled
def _shares(phases: Floats) -> Floats:
    """Relative changes (19,) at scale 1 from the phases of all waves, bone by bone, within the largest change of a bone."""
    out = np.empty(len(_CHILD))
    for bone in range(len(_CHILD)):
        total = 0.0
        for wave in range(_WAVES):
            total += math.cos(phases[bone * _WAVES + wave])
        out[bone] = min(max(_SPREAD[bone] * total * _WAVE_SIZE, -_LARGEST), _LARGEST)
    return out


@compiled
def _changes(phases: Floats, directions: Floats, lengths: Floats, scale: float) -> tuple[Floats, Floats]:
    """Matrix (19, 19) and right-hand side (19,) m of the pulls along the bones that change their lengths."""
    share, change = _shares(phases), np.empty(len(lengths))
    gram = _RIDGE.copy()
    for bone in range(len(lengths)):
        change[bone] = min(max(scale * share[bone], -_LARGEST), _LARGEST) * lengths[bone]
        for other in range(len(lengths)):
            along = 0.0
            for axis in range(3):
                along += directions[bone, axis] * directions[other, axis]
            gram[bone, other] += _COUPLING[bone, other] * along
    return gram, change


@compiled
def _displacement(phases: Floats, directions: Floats, lengths: Floats, scale: float) -> Floats:
    """(20, 3) m: the displacement that changes the bones as the phases of their waves say."""
    gram, pull = _changes(phases, directions, lengths, scale)
    solve_definite(gram, pull)
    return _displaced(pull, directions)


@compiled
def _displaced(pull: Floats, directions: Floats) -> Floats:
    """(20, 3) m: what the pulls (19,) along the bones do to their two ends."""
    out = np.zeros((JOINT_COUNT, 3))
    for bone in range(len(pull)):
        for axis in range(3):
            way = pull[bone] * directions[bone, axis]
            out[_CHILD[bone], axis] += _MOBILITY[_CHILD[bone]] * way
            out[_PARENT[bone], axis] -= _MOBILITY[_PARENT[bone]] * way
    return out


class BoneLengthBias:
    """Displaces joints so that every bone has the length the sensor would report in this pose."""

    def __init__(self, rng: np.random.Generator) -> None:
        bones = len(BONES)
        reach = np.full((bones, bones), _OTHERS)
        reach[np.arange(bones), np.arange(bones)] = _OWN
        self._waves = rng.standard_normal((bones, _WAVES, bones, 3)) * reach[:, None, :, None]
        self._waves = self._waves.reshape(bones * _WAVES, bones * 3)
        self._phases = rng.uniform(0.0, 2.0 * np.pi, bones * _WAVES)

    def shares(self, directions: Floats) -> Floats:
        """Relative change of each bone at scale 1, (19,), for unit bone directions (19, 3)."""
        return _shares(self._waves @ directions.reshape(-1) + self._phases)

    def displacement(self, positions: Floats, scale: float) -> Floats:
        """The smallest weighted joint displacement, (20, 3) metres, that changes every bone's length by its share.

        To first order along each bone u_b . (d_child - d_parent) = share_b length_b: a weighted minimum-norm solution.
        """
        directions, lengths = _directions_and_lengths(positions)
        return _displacement(self._waves @ directions.reshape(-1) + self._phases, directions, lengths, scale)
