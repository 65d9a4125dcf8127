"""What the player wants of the feet, as the character is to understand it."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import JOINT_COUNT
from game.compiled import compiled
from game.control.joint_command import BodyState
from game.control.whole_body.motion_window import Motion
from game.control.whole_body.player_stance import Overlay, PlayerStance, laid_over
from game.control.whole_body.sole import ahead_of_ankle

Floats = NDArray[np.float64]

INWARD_RAD, OUTWARD_RAD = 0.3, 0.8
"""How far a foot turns in its leg; what points elsewhere was not seen well."""

MOST_TURN_RAD = 0.7
"""A foot is wanted turned no farther than this from where the pelvis faces: whoever faces elsewhere turns there in steps."""

LEAST_APART_M = 0.15
"""The soles stand at least so far apart, sideways: no foot on the other one."""


@dataclass(frozen=True)
class Wish:
    """What the player does: feet up, in flight, where each sole should stand (world xy, 2 x 2) and its yaw; in place and yaw he is turned
    by `back_rad` towards where the character faces."""

    up: tuple[bool, bool]
    flight: bool
    place: Floats
    yaw: tuple[float, float]
    back_rad: float = 0.0


def wish_of(player: PlayerStance, motion: Motion, body: BodyState) -> Wish:
    """What the player wants of the feet: which are up, and where the soles should stand in the character's world."""
    place = np.empty((2, 2))
    facing = one.yaw(body.orientation[0])
    left, right, back = _wished_soles(motion.turn, motion.place, player.overlay, player.turn_rad, ahead_of_ankle(body), facing, place)
    return Wish((player.up[0], player.up[1]), player.flight, place, (left, right), back)


@compiled
def _wished_soles(
    turn: Floats, place: Floats, overlay: Overlay, turn_rad: float, ahead_m: float, facing: float, out: Floats
) -> tuple[float, float, float]:
    """Write the places (2, 2) of the soles, so far ahead of their ankles; gives their yaws and `back_rad`.

    turn (17, 4), place (4, 3) of a `Motion`; facing: the heading of the character's pelvis, rad; one that faces far elsewhere than
    the player turns there step by step.
    """
    heading = one.yaw(turn[JOINT_COUNT])
    left = heading + min(max(one.wrapped(one.yaw(turn[JOINT_COUNT + 1]) - heading), -INWARD_RAD), OUTWARD_RAD) + turn_rad
    right = heading - min(max(-one.wrapped(one.yaw(turn[JOINT_COUNT + 2]) - heading), -INWARD_RAD), OUTWARD_RAD) + turn_rad
    for side in range(2):
        yaw = left if side == 0 else right
        ankle = laid_over(place[1 + side], overlay)
        out[side, 0], out[side, 1] = ankle[0] + ahead_m * math.cos(yaw), ankle[1] + ahead_m * math.sin(yaw)
    back = one.turn_within(one.wrapped(heading + turn_rad), facing, MOST_TURN_RAD)
    if back != 0.0:
        left, right = left + back, right + back
        _turn_about_middle(out, back)
    c, s = math.cos(heading + turn_rad + back), math.sin(heading + turn_rad + back)
    short = LEAST_APART_M - (-s * (out[0, 0] - out[1, 0]) + c * (out[0, 1] - out[1, 1]))
    if short > 0.0:
        out[0, 0] -= 0.5 * short * s
        out[0, 1] += 0.5 * short * c
        out[1, 0] += 0.5 * short * s
        out[1, 1] -= 0.5 * short * c
    return left, right, back


@compiled
def _turn_about_middle(places: Floats, angle_rad: float) -> None:
    """Turn two places (2, 2) about the point half-way between them."""
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    x, y = 0.5 * (places[0, 0] - places[1, 0]), 0.5 * (places[0, 1] - places[1, 1])
    across, along = c * x - s * y - x, s * x + c * y - y
    places[0, 0] += across
    places[0, 1] += along
    places[1, 0] -= across
    places[1, 1] -= along
