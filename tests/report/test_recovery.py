"""The rule by which a push counts as recovered from, held against bodies that are moved by hand."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import load_body_plan
from game.characters.skeleton import FEET, PARTS
from game.report.recovery import HELD_S, LIMIT_S, MOST_STEPS, STANCE_M, STEP_M, Recovery
from game.rotation import Floats
from game.target.forward_kinematics import PosedSkeleton, pose_skeleton
from tests.report.observed import elsewhere, target_of

PLAN = load_body_plan("original")
IDLE = pose_skeleton(PLAN, PLAN.joint[0], rotation.IDENTITY, np.tile(rotation.IDENTITY, (14, 1)))
TARGET = target_of(PLAN, IDLE)
PUSH_S, DT = 0.2, 1.0 / 60.0
SOLES = FEET


@dataclass(frozen=True)
class Body:
    joint: Floats
    orientation: Floats
    foot_contact: tuple[bool, bool] = (True, True)


def body(pose: PosedSkeleton = IDLE, touches: tuple[bool, bool] = (True, True)) -> Body:
    return Body(pose.joint, pose.orientation, touches)


def judge(at, on_floor=lambda t: SOLES) -> Recovery:
    """`at`: the body at a time since the push began."""
    rule, frame = Recovery(body(), TARGET, PUSH_S), 0
    while not rule.outcome:
        frame += 1
        assert frame < 300
        rule.see(frame * DT, at(frame * DT), TARGET, on_floor(frame * DT))
    return rule


def foot_moved(side: int, by: tuple[float, float, float]) -> Body:
    joint = IDLE.joint.copy()
    joint[FEET[side]] += by
    return replace(body(), joint=joint)


def tilted(angle_rad: float) -> Body:
    orientation = IDLE.orientation.copy()
    orientation[PARTS.index("trunk")] = rotation.exp(np.array([0.0, angle_rad, 0.0]))
    return replace(body(), orientation=orientation)


def test_who_does_not_move_has_recovered_and_is_back_as_soon_as_the_push_ends():
    rule = judge(lambda t: body())
    assert rule.outcome == "recovered" and rule.steps == 0
    assert rule.back_s == pytest.approx(PUSH_S, abs=1.5 * DT)


def test_it_is_judged_at_the_end_and_not_before():
    rule = Recovery(body(), TARGET, PUSH_S)
    for frame in range(1, int((LIMIT_S - DT) / DT)):
        rule.see(frame * DT, body(), TARGET, SOLES)
    assert rule.outcome == "" and rule.back_s is not None
    rule.see(LIMIT_S - DT, tilted(1.2), TARGET, SOLES)
    assert rule.outcome == "trunk down"


def test_a_hand_on_the_floor_is_a_fall():
    rule = judge(lambda t: body(), lambda t: (*SOLES, PARTS.index("hand_left")) if t > 1.0 else SOLES)
    assert rule.outcome == "hand left on the floor"


@pytest.mark.parametrize(("angle_deg", "outcome"), [(59.0, "recovered"), (61.0, "trunk down")])
def test_the_trunk_may_lean_to_sixty_degrees(angle_deg, outcome):
    assert judge(lambda t: tilted(np.radians(angle_deg)) if 0.5 < t < 1.0 else body()).outcome == outcome


def test_a_body_that_is_no_number_has_not_recovered():
    broken = replace(body(), orientation=np.full((15, 4), np.nan))
    assert judge(lambda t: broken if t > 1.0 else body()).outcome == "trunk down"


@pytest.mark.parametrize("steps", [1, MOST_STEPS, MOST_STEPS + 1])
def test_steps_are_counted_and_more_than_three_are_too_many(steps):
    def at(t):
        """A left foot that steps out and back every 0.3 s: up for half of that."""
        number, phase = divmod(t - 0.3, 0.3)
        if t < 0.3 or number >= steps:
            return foot_moved(0, (0.0, (2.0 * STEP_M if steps % 2 and t > 0.3 else 0.0), 0.0))
        came_down = number % 2 == 0 if phase > 0.15 else number % 2 == 1
        return replace(foot_moved(0, (0.0, 2.0 * STEP_M * came_down, 0.0)), foot_contact=(phase > 0.15, True))

    rule = judge(at)
    assert rule.outcome == ("too many steps" if steps > MOST_STEPS else "recovered")
    assert rule.steps == steps


def test_a_sole_that_grazes_the_floor_on_its_way_has_taken_no_step():
    def at(t):
        """A left foot in the air for 0.4 s, which touches for two frames half-way."""
        grazes = abs(t - 0.7) < 1.2 * DT
        way = 0.0 if t < 0.5 else min((t - 0.5) / 0.4, 1.0)
        return replace(foot_moved(0, (0.0, 2.0 * STEP_M * way, 0.0)), foot_contact=(not 0.5 < t < 0.9 or grazes, True))

    assert judge(at).steps == 1


def test_a_foot_that_comes_down_where_it_stood_has_taken_no_step():
    rule = judge(lambda t: body(touches=(not 0.5 < t < 0.8, True)))
    assert rule.outcome == "recovered" and rule.steps == 0


@pytest.mark.parametrize(("away_m", "outcome"), [(0.9 * STANCE_M, "recovered"), (1.1 * STANCE_M, "not back in stance")])
def test_a_foot_must_be_where_the_player_has_his(away_m, outcome):
    assert judge(lambda t: foot_moved(0, (away_m, 0.0, 0.0)) if t > 0.1 else body()).outcome == outcome


@pytest.mark.parametrize(("angle_deg", "outcome"), [(9.0, "recovered"), (11.0, "not back in stance")])
def test_the_body_must_face_where_the_player_faces(angle_deg, outcome):
    turned = body(elsewhere(PLAN, IDLE, np.radians(angle_deg), (0.0, 0.0, 0.0)))
    assert judge(lambda t: turned if t > 0.1 else body()).outcome == outcome


def test_where_in_the_room_it_stands_does_not_count():
    gone = body(elsewhere(PLAN, IDLE, 0.0, (0.7, -0.3, 0.0)))
    assert judge(lambda t: gone if t > 0.1 else body()).outcome == "recovered"


def test_a_stance_that_is_met_in_passing_is_not_met():
    def at(t):
        return body() if t < 0.1 or 1.0 < t < 1.0 + 0.8 * HELD_S else foot_moved(0, (2.0 * STANCE_M, 0.0, 0.0))

    assert judge(at).outcome == "not back in stance"
