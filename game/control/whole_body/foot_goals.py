"""Which of the foot tasks a foot has right now, and where it is to go: after the player's foot, on a step of its own, or under the body."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import FEET, JOINT_COUNT
from game.compiled import compiled
from game.control.joint_command import BodyState
from game.control.whole_body.contact_states import FootState, Phase
from game.control.whole_body.foot_tasks import flight, follow, stance, swing
from game.control.whole_body.footing import Wish
from game.control.whole_body.motion_window import Motion
from game.control.whole_body.player_stance import Overlay, PlayerStance, laid_over
from game.control.whole_body.sole import Sole, ahead_of_ankle

Floats = NDArray[np.float64]

CLEARANCE_M = 0.06
"""How high a step of its own swings."""

INWARD_RAD, OUTWARD_RAD = 0.3, 0.8
"""How far a foot turns in its leg; what points elsewhere was not seen well."""

LEAST_APART_M = 0.15
"""The soles stand at least so far apart, sideways: no foot on the other one."""

_STILL = np.zeros(3)


def wish_of(player: PlayerStance, motion: Motion, body: BodyState) -> Wish:
    """What the player wants of the feet: which are up, and where the soles should stand in the character's world."""
    place = np.empty((2, 2))
    yaws = _wished_soles(motion.turn, motion.place, player.overlay, player.turn_rad, ahead_of_ankle(body), place)
    return Wish((player.up[0], player.up[1]), player.flight, place, yaws)


@compiled
def _wished_soles(turn: Floats, place: Floats, overlay: Overlay, turn_rad: float, ahead_m: float, out: Floats) -> tuple[float, float]:
    """Write the places (2, 2) of the soles, so far ahead of their ankles, and give their yaws; turn (17, 4), place (4, 3) of a `Motion`."""
    heading = one.yaw(turn[JOINT_COUNT])
    left = heading + min(max(one.wrapped(one.yaw(turn[JOINT_COUNT + 1]) - heading), -INWARD_RAD), OUTWARD_RAD) + turn_rad
    right = heading - min(max(-one.wrapped(one.yaw(turn[JOINT_COUNT + 2]) - heading), -INWARD_RAD), OUTWARD_RAD) + turn_rad
    for side in range(2):
        yaw = left if side == 0 else right
        ankle = laid_over(place[1 + side], overlay)
        out[side, 0], out[side, 1] = ankle[0] + ahead_m * math.cos(yaw), ankle[1] + ahead_m * math.sin(yaw)
    c, s = math.cos(heading + turn_rad), math.sin(heading + turn_rad)
    short = LEAST_APART_M - (-s * (out[0, 0] - out[1, 0]) + c * (out[0, 1] - out[1, 1]))
    if short > 0.0:
        out[0, 0] -= 0.5 * short * s
        out[0, 1] += 0.5 * short * c
        out[1, 0] += 0.5 * short * s
        out[1, 1] -= 0.5 * short * c
    return left, right


def foot_task(
    side: int, sole: Sole, foot: FootState, twist: Floats, motion: Motion, player: PlayerStance, wish: Wish, body: BodyState,
    weight: Floats, goal: Floats,
) -> None:  # fmt: skip
    """Fill weight (6,) and goal (6,), an acceleration, of a sole that moves with `twist` (6,), feet not in flight."""
    turn = body.turn[FEET[side]]
    if foot.stands:
        stance(twist, turn, sole.centre[2], sole.touches, foot.time_s, weight, goal)
        return
    orientation = body.orientation[FEET[side]]
    if foot.phase is Phase.STEP:
        place, velocity, acceleration, yaw = foot.step_motion(CLEARANCE_M)
        swing(sole.centre, orientation, turn, twist, place, velocity, acceleration, one.about_z(yaw), _STILL, weight, goal)
        return
    follow(
        side, sole.centre, orientation, turn, twist, player.up[side], wish.place[side], wish.yaw[side], body.plan.joint[FEET[0], 2],
        tuple(motion), player.overlay, player.turn_rad, foot.behind, foot.time_s, foot.fresh, weight, goal,
    )  # fmt: skip
    foot.fresh = False


def flight_task(
    side: int, sole: Sole, twist: Floats, xi: Floats, motion: Motion, player: PlayerStance, wish: Wish, body: BodyState,
    weight: Floats, goal: Floats,
) -> None:  # fmt: skip
    """Fill weight (6,) and goal (6,) of a sole in the air: below the capture point xi (2,), apart as the player's feet are."""
    apart = player.direction(motion.place[1 + side] - 0.5 * (motion.place[1] + motion.place[2]))[:2]
    under = xi + apart
    orientation, turn = body.orientation[FEET[side]], body.turn[FEET[side]]
    flight(sole.centre, orientation, turn, twist, under, body.com_velocity, one.about_z(wish.yaw[side]), weight, goal)
