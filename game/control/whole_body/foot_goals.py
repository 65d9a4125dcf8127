"""Which of the foot tasks a foot has right now, and where it is to go: after the player's foot, on a step of its own, or under the body."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import FEET, JOINT_COUNT
from game.control.joint_command import BodyState
from game.control.whole_body.contact_states import FootState, Phase
from game.control.whole_body.foot_tasks import CATCH_UP_S, flight, stance, swing
from game.control.whole_body.footing import Wish
from game.control.whole_body.motion_window import Motion
from game.control.whole_body.player_stance import PlayerStance
from game.control.whole_body.sole import Sole, ahead_of_ankle

Floats = NDArray[np.float64]

CLEARANCE_M = 0.06
"""How high a step of its own swings."""

LEAST_LIFT_M, PRESS_M = 0.02, 0.01
"""A foot that the player has up is this far off the floor at least; one that he has down is aimed this far below it."""

INWARD_RAD, OUTWARD_RAD = 0.3, 0.8
"""How far a foot turns in its leg; what points elsewhere was not seen well."""

LEAST_APART_M = 0.15
"""The soles stand at least so far apart, sideways: no foot on the other one."""

_STILL = np.zeros(3)


def wish_of(player: PlayerStance, motion: Motion, body: BodyState) -> Wish:
    """What the player wants of the feet: which are up, and where the soles should stand in the character's world."""
    place, yaw = np.empty((2, 2)), [0.0, 0.0]
    heading = one.yaw(motion.root)
    for side in range(2):
        outward = 1.0 if side == 0 else -1.0
        turned = outward * math.remainder(one.yaw(motion.turn[JOINT_COUNT + 1 + side]) - heading, math.tau)
        yaw[side] = heading + outward * min(max(turned, -INWARD_RAD), OUTWARD_RAD) + player.turn_rad
        place[side] = player.ankle(motion, side)[:2] + ahead_of_ankle(body, yaw[side])
    c, s = math.cos(heading + player.turn_rad), math.sin(heading + player.turn_rad)
    apart = place[0] - place[1]
    short = LEAST_APART_M - (-s * apart[0] + c * apart[1])
    if short > 0.0:
        place[0] += 0.5 * short * np.array([-s, c])
        place[1] -= 0.5 * short * np.array([-s, c])
    return Wish((player.up[0], player.up[1]), player.flight, place, (yaw[0], yaw[1]))


def foot_task(
    side: int, sole: Sole, foot: FootState, twist: Floats, motion: Motion, player: PlayerStance, wish: Wish, body: BodyState
) -> tuple[Floats, Floats]:
    """Weights (6,) and acceleration (6,) of a sole that moves with `twist` (6,), feet not in flight."""
    orientation, turn = body.orientation[FEET[side]], body.turn[FEET[side]]
    if foot.stands:
        return stance(twist, turn, sole.centre[2], sole.touches, foot.time_s)
    if foot.phase is Phase.STEP:
        place, velocity, acceleration, yaw = foot.step_motion(CLEARANCE_M)
        return swing(sole.centre, orientation, turn, twist, place, velocity, acceleration, one.about_z(yaw), _STILL)
    place = np.array([*wish.place[side], player.ankle(motion, side)[2] - body.plan.joint[FEET[0], 2]])
    if player.up[side]:
        facing = player.orientation(motion.turn[JOINT_COUNT + 1 + side])
        place[2] = max(place[2], LEAST_LIFT_M)
    else:
        facing = one.about_z(wish.yaw[side])
        place[2] = min(place[2], 0.0) - PRESS_M
    velocity, acceleration = player.direction(motion.velocity[1 + side]), player.direction(motion.acceleration[1 + side])
    if foot.fresh:
        foot.fresh = False
        foot.behind = sole.centre - place
    left = max(1.0 - foot.time_s / CATCH_UP_S, 0.0)
    place += left * left * foot.behind
    velocity -= 2.0 * left / CATCH_UP_S * foot.behind
    return swing(sole.centre, orientation, turn, twist, place, velocity, acceleration, facing, motion.spin[JOINT_COUNT + 1 + side])


def flight_task(
    side: int, sole: Sole, twist: Floats, xi: Floats, motion: Motion, player: PlayerStance, wish: Wish, body: BodyState
) -> tuple[Floats, Floats]:
    """Weights (6,) and acceleration (6,) of a sole in the air: below the capture point xi (2,), apart as the player's feet are."""
    apart = player.direction(motion.place[1 + side] - 0.5 * (motion.place[1] + motion.place[2]))[:2]
    under = xi + apart
    orientation, turn = body.orientation[FEET[side]], body.turn[FEET[side]]
    return flight(sole.centre, orientation, turn, twist, under, body.com_velocity, one.about_z(wish.yaw[side]))
