"""Which of the foot tasks a foot has right now, and where it is to go: after the player's foot, on a step of its own, or under the body."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import FEET
from game.control.joint_command import BodyState
from game.control.whole_body.contact_states import FootState, Phase
from game.control.whole_body.foot_tasks import flight, follow, stance, swing
from game.control.whole_body.motion_window import Motion
from game.control.whole_body.player_stance import PlayerStance
from game.control.whole_body.sole import Sole
from game.control.whole_body.wish import Wish

Floats = NDArray[np.float64]

CLEARANCE_M, ROUND_CLEARANCE_M = 0.075, 0.116
"""How high a step of its own swings, and one round the other leg."""

BENT_M = 0.05
"""How much shorter than standing the legs are that wait for the floor."""


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
        rounds = foot.saving is not None and foot.saving.round_m != 0.0
        place, velocity, acceleration, yaw, rate = foot.step_motion(ROUND_CLEARANCE_M if rounds else CLEARANCE_M)
        spin = np.array([0.0, 0.0, rate])
        swing(sole.centre, orientation, turn, twist, place, velocity, acceleration, one.about_z(yaw), spin, weight, goal)
        return
    follow(
        side, sole.centre, orientation, turn, twist, player.up[side], wish.place[side], wish.yaw[side], body.plan.joint[FEET[0], 2],
        tuple(motion), player.overlay, player.turn_rad + wish.back_rad, foot.behind, foot.time_s, foot.fresh, weight, goal,
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
    legs_end_m = body.com[2] - body.plan.idle_com_height + BENT_M
    flight(sole.centre, orientation, turn, twist, under, body.com_velocity, one.about_z(wish.yaw[side]), legs_end_m, weight, goal)
