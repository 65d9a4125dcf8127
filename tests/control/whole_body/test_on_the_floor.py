"""What becomes of a body that has fallen: it rests, gets up, stands up; and stays down after too many tries."""

import numpy as np
import pytest

from game import rotation
from game.characters.strength import joint_strength
from game.control.whole_body.getting_up import ROLLS_ON_S, GettingUp
from game.control.whole_body.key_poses import key_poses
from game.control.whole_body.on_the_floor import LEAST_FALL_S, MOST_FALL_S, MOST_TRIES, STAND_UP_S, OnTheFloor, Stage
from tests.physics.standing import idle_joints, original, world_of

DT = 1.0 / 60.0
STRENGTH = np.array(joint_strength(original()))
ON_ITS_FRONT = rotation.exp(np.array([0.0, 0.5 * np.pi, 0.0]))
ON_ITS_SIDE = rotation.exp(np.array([0.5 * np.pi, 0.0, 0.0]))


def lying(turn=ON_ITS_FRONT):
    """A body that hovers: nothing it is told moves it."""
    world = world_of((0.0, 0.0, 0.0))
    world.place(0, np.array([0.0, 0.0, 0.3]), turn, idle_joints())
    return world.characters[0]


def pass_time(floor, body, seconds, gets_up=True):
    """The stages it goes through."""
    seen = [floor.stage]
    for _ in range(round(seconds / DT)):
        floor.stands_ready(body, gets_up, DT)
        floor.command(body, STRENGTH, 1.0, DT)
        if floor.stage is not seen[-1]:
            seen.append(floor.stage)
    return seen


def test_it_lies_for_a_moment_then_gets_up():
    floor, body = OnTheFloor(), lying()
    floor.fall()
    assert pass_time(floor, body, LEAST_FALL_S - 0.1) == [Stage.FALLING]
    assert pass_time(floor, body, 0.2) == [Stage.FALLING, Stage.GETTING_UP]
    assert floor.lies and floor.tries == 1


def test_a_body_that_still_moves_waits_but_not_for_ever():
    floor, body = OnTheFloor(), lying()
    world_velocity = body._velocity  # the body's own view of the world it hovers in
    world_velocity[6:] = 5.0
    floor.fall()
    assert pass_time(floor, body, MOST_FALL_S - 0.1) == [Stage.FALLING]
    assert pass_time(floor, body, 0.2) == [Stage.FALLING, Stage.GETTING_UP]


def test_after_the_last_try_it_stays_down():
    floor, body = OnTheFloor(), lying()
    floor.fall()
    seen = pass_time(floor, body, 60.0)
    assert seen == [Stage.FALLING, Stage.GETTING_UP] * MOST_TRIES + [Stage.FALLING, Stage.DOWN]
    assert floor.stays_down and floor.lies
    assert pass_time(floor, body, 5.0) == [Stage.DOWN]


def test_who_is_not_to_get_up_lies():
    floor = OnTheFloor()
    floor.fall()
    assert pass_time(floor, lying(), 10.0, gets_up=False) == [Stage.FALLING] and not floor.stays_down


def test_who_lies_on_the_side_rolls_first_and_that_is_no_try_of_its_own():
    floor, body = OnTheFloor(), lying(ON_ITS_SIDE)
    floor.fall()
    pass_time(floor, body, LEAST_FALL_S + 2 * DT)
    assert floor._try is not None and floor._try.route == "side"
    pass_time(floor, body, sum(pose.seconds for pose in key_poses()["side"]) + 0.1)
    assert floor._try.route in ("supine", "prone") and floor.tries == 1


def test_who_tips_over_on_the_way_up_begins_anew_at_once_from_the_side():
    floor, body = OnTheFloor(), lying()
    floor.fall()
    pass_time(floor, body, LEAST_FALL_S + 2 * DT)
    assert floor._try is not None and floor._try.route == "prone" and floor.tries == 1
    floor.stands_ready(lying(ON_ITS_SIDE), True, DT)
    assert floor._try.route == "side" and floor.tries == 2 and floor.stage is Stage.GETTING_UP


def test_who_does_not_roll_over_from_the_side_to_the_front_begins_anew_before_the_way_up_is_over():
    floor, side = OnTheFloor(), lying(ON_ITS_SIDE)
    floor.stage, floor._try = Stage.GETTING_UP, GettingUp(side, "prone")
    assert pass_time(floor, side, ROLLS_ON_S - 0.1) == [Stage.GETTING_UP] and floor.tries == 0
    pass_time(floor, side, 0.2)
    assert floor._try.route == "side" and floor.tries == 1


def test_feet_that_can_take_over_end_the_lying():
    world = world_of((0.0, 0.0, 0.0))
    floor, body = OnTheFloor(), world.characters[0]
    floor.fall()
    for _ in range(600):
        if floor.stands_ready(body, True, DT):
            break
    assert floor.stage is Stage.STANDING_UP and not floor.lies


@pytest.mark.parametrize(("heights", "stage"), [([0.5, 0.7, 0.9], Stage.UP), ([0.5, 0.25], Stage.FALLING)])
def test_standing_up_ends_at_the_players_height_or_on_the_floor(heights, stage):
    floor = OnTheFloor()
    floor.stage, floor.tries = Stage.STANDING_UP, 2
    for height in heights:
        floor.rise(height, 1.0, DT)
    assert floor.stage is stage
    assert floor.tries == (0 if stage is Stage.UP else 2)


def test_who_does_not_come_up_in_time_begins_anew():
    floor = OnTheFloor()
    floor.stage = Stage.STANDING_UP
    for _ in range(round((STAND_UP_S + 0.1) / DT)):
        if floor.stage is Stage.STANDING_UP:
            floor.rise(0.6, 1.0, DT)
    assert floor.stage is Stage.FALLING
