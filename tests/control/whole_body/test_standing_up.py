"""Standing up: from the pose and height of a crouching body to those of the player, smoothly."""

import numpy as np
import pytest

from game import rotation
from game.characters.skeleton import JOINT_COUNT
from game.control.whole_body.motion_window import Motion
from game.control.whole_body.player_stance import PlayerStance
from game.control.whole_body.standing_up import STAND_UP_S, StandingUp
from tests.physics.standing import bent, original, world_of

CROUCH = bent(hip_left=(0.0, -1.2, 0.0), hip_right=(0.0, -1.2, 0.0), knee_left=(0.0, 1.5, 0.0), knee_right=(0.0, 1.5, 0.0))
DT = 1e-4


def begun():
    body = world_of((0.0, 0.0, -0.3), joints=CROUCH).characters[0]
    player = PlayerStance(float(original().joint[11, 2]))
    return body, StandingUp(body, player)


def players_motion():
    rng = np.random.default_rng(1)
    turn = rotation.normalise(np.tile(rotation.IDENTITY, (17, 1)) + 0.1 * rng.normal(size=(17, 4)))
    place = np.array([[0.0, 0.0, 1.0], [0.0, 0.1, 0.08], [0.0, -0.1, 0.08], [0.0, 0.0, 0.95]])
    return Motion(turn, np.zeros((17, 3)), np.zeros((17, 3)), place, np.zeros((4, 3)), np.zeros((4, 3)))


def test_it_begins_where_the_body_is_and_ends_where_the_player_is():
    body, rising = begun()
    motion = players_motion()
    first = rising.on_the_way(motion, 1e-9)
    np.testing.assert_allclose(first.joint, body.joint_rotation, atol=1e-9)
    np.testing.assert_allclose(first.root, body.orientation[0], atol=1e-9)
    assert first.place[3, 2] == pytest.approx(body.com[2]) and not rising.done
    last = rising.on_the_way(motion, STAND_UP_S)
    assert rising.done
    np.testing.assert_allclose(np.abs(np.sum(last.turn * motion.turn, axis=1)), 1.0, atol=1e-12)
    np.testing.assert_allclose(last.place, motion.place)
    np.testing.assert_allclose(last.spin, 0.0, atol=1e-12)


def test_its_speeds_are_those_at_which_its_poses_change():
    _, rising = begun()
    motion = players_motion()
    before, middle, after = (rising.on_the_way(motion, step) for step in (0.4 * STAND_UP_S, DT, DT))
    turned = rotation.log(rotation.multiply(rotation.conjugate(before.turn), after.turn))[: JOINT_COUNT + 1] / (2.0 * DT)
    np.testing.assert_allclose(middle.spin[: JOINT_COUNT + 1], turned, atol=1e-5)
    spun = (after.spin - before.spin)[: JOINT_COUNT + 1] / (2.0 * DT)
    np.testing.assert_allclose(middle.spin_rate[: JOINT_COUNT + 1], spun, atol=1e-4)
    rise = (after.place[3, 2] - before.place[3, 2]) / (2.0 * DT)
    assert middle.velocity[3, 2] == pytest.approx(rise, abs=1e-6)
    assert middle.acceleration[3, 2] == pytest.approx((after.velocity[3, 2] - before.velocity[3, 2]) / (2.0 * DT), abs=1e-4)


def test_feet_and_places_stay_the_players():
    _, rising = begun()
    motion = players_motion()
    on_the_way = rising.on_the_way(motion, 0.5 * STAND_UP_S)
    np.testing.assert_array_equal(on_the_way.turn[JOINT_COUNT + 1 :], motion.turn[JOINT_COUNT + 1 :])
    np.testing.assert_array_equal(on_the_way.place[:3], motion.place[:3])
    np.testing.assert_array_equal(on_the_way.place[3, :2], motion.place[3, :2])
