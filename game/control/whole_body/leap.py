"""How high the COM should be: at the player's height on the floor, after him in a jump, and softly down at the landing."""

import math

from game.control.joint_command import BodyState
from game.control.whole_body.footing import Footing
from game.control.whole_body.motion_window import Motion, MotionWindow
from game.control.whole_body.player_stance import PlayerStance
from game.control.whole_body.sole import leg_reach, rise_left

LEAST_LEAP_M = 0.075
"""A player who rises with a swing that would carry him this far above standing is about to jump."""

HIGHEST_LEAP_M = 0.4
"""Nobody is followed higher than that."""

SEEN_SHORT = 1.5
"""A smoothed push-off ends before it is seen to: the swing carries farther than its parabola."""

STRAIGHT = 0.98
"""Reach of a leg that has nothing more to push with."""

RISING_M_S, PUSHING_M_S = 0.35, 0.6
LANDING_S, RISE_RATE, SINK_RATE = 0.6, 30.0, 12.0
"""So long at most a landing is softened: by 1/s^2 of the way left up to the player, once he has landed too, and 1/s of the speed."""

LOWEST, HIGHEST = -8.0, 20.0
"""m/s^2 the COM may be asked for."""

BRAKE, BRAKE_RATE = 5.0, 15.0
"""m/s^2 that rising hips are stopped with before the legs are straight, where nobody leaps; 1/s of what they are too fast."""


def leap_speed(window: MotionWindow, player: PlayerStance, body: BodyState) -> float:
    """m/s upwards that would carry the COM as high as the player's is going, by the newest frames; 0 where nobody leaps."""
    seen_m, speed = window.newest_rise
    rise, height = max(speed, 0.0), seen_m - player.floor_z
    swing = SEEN_SHORT * rise * rise / (2.0 * body.gravity)
    standing = body.plan.idle_com_height
    if not player.flight and height + swing < standing + LEAST_LEAP_M:
        return 0.0
    # legs that are still bent go on pushing: the swing counts from where they are straight
    apex = max(height, standing) + swing
    return math.sqrt(2.0 * body.gravity * max(min(apex, standing + HIGHEST_LEAP_M) - body.com[2], 0.0))


def taking_off(leap: float, player: PlayerStance, body: BodyState, load_n: float) -> bool:
    """The COM rises on straight legs, or fast enough on unloaded feet: the floor has nothing more to give. leap: `leap_speed`."""
    speed = float(body.com_velocity[2])
    if speed < RISING_M_S:
        return False
    if not any(body.foot_contact):
        return True
    if speed > PUSHING_M_S and leap > PUSHING_M_S and max(leg_reach(body, side) for side in range(2)) > STRAIGHT:
        return True
    unloaded = load_n < 0.08 * body.subtree_mass[0] * body.gravity
    return player.flight and unloaded and speed > leap - 0.1


class ComHeight:
    """Remembers a landing until it is over."""

    def __init__(self) -> None:
        self._landing = False

    def acceleration(self, motion: Motion, rising: float, leap: float, player: PlayerStance, footing: Footing, body: BodyState) -> float:
        """m/s^2 upwards that the COM is asked for; rising: m/s of the player's in the newest frame, leap: `leap_speed`."""
        height, speed = float(motion.place[3, 2]) - player.floor_z, float(body.com_velocity[2])
        com_height, rise = float(body.com[2]), float(motion.velocity[3, 2])
        if footing.landed_s < LANDING_S:
            self._landing = (self._landing or footing.landed_s < 0.02) and height > com_height
            if self._landing:
                # not after the player up into the air again: soften the landing until he has come down too
                follow = 0.0 if player.flight else RISE_RATE * (height - com_height) + SINK_RATE * max(rise, 0.0)
                return min(max(follow - SINK_RATE * speed, -5.0), 9.0)
        wanted = 100.0 * (height - com_height) + 20.0 * (rise - speed) + float(motion.acceleration[3, 2])
        if leap > 0.0 and rise > 0.3:
            wanted = max(wanted, 30.0 * (leap - speed))
        else:
            # legs that run out of length while the hips still rise would throw the body off the floor
            room = min((rise_left(body, side) for side in range(2) if footing.feet[side].stands), default=0.0)
            excess = float(body.velocity[2]) - max(math.sqrt(2.0 * BRAKE * max(room, 0.0)), rising)
            if excess > 0.0:
                wanted = min(wanted, -BRAKE_RATE * excess)
        return min(max(wanted, LOWEST), HIGHEST)
