"""The observer samples at 30 Hz after the hang and as long as the character is upright."""

from types import SimpleNamespace
from typing import Any

import pytest

from game.characters.body_plan import load_body_plan
from game.physics.world import FRAME_HZ
from game.report.observer import SAMPLE_HZ, Observer
from tests.report.observed import body_in, target_of
from tests.target.players import idle

PLAN = load_body_plan("original")
POSE = idle(PLAN)


def watched(com_heights: list[float], first_frame: int) -> Observer:
    """An observer of a character that stands idle, with the given height of its centre of mass frame by frame."""
    fighter: Any = SimpleNamespace(index=0, plan=PLAN, target=target_of(PLAN, POSE))
    observer = Observer(fighter)
    for k, height in enumerate(com_heights):
        frame = first_frame + k
        body = SimpleNamespace(**vars(body_in(POSE)), joint_rotation=POSE.joint_rotation, com_height=lambda height=height: height)
        simulation: Any = SimpleNamespace(frame=frame, time_s=frame / FRAME_HZ, world=SimpleNamespace(characters=[body]))
        observer.observe(simulation)
    return observer


def test_the_hang_is_not_counted():
    observer = watched([0.0] * 30 + [0.93] * 60, first_frame=-29)
    assert observer.upright.upright and observer.upright.upright_s == pytest.approx(1.0)


def test_two_seconds_give_sixty_samples():
    observer = watched([0.93] * 120, first_frame=1)
    assert len(observer.wrists._own) == 2 * SAMPLE_HZ
    assert observer.error.summary()["joint_error_parent_rad"] == pytest.approx(0.0, abs=1e-12)


def test_nothing_is_sampled_after_the_fall():
    observer = watched([0.93] * 60 + [0.3] + [0.93] * 60, first_frame=1)
    assert len(observer.wrists._own) == SAMPLE_HZ
    summary = observer.summary()
    assert summary["upright_s"] == pytest.approx(1.0)
    assert summary["fell_at_s"] == pytest.approx(61.0 / FRAME_HZ)


def test_the_summary_holds_what_a_report_needs():
    errors = {
        f"{n}{s}"
        for n in ("joint_error_parent_rad", "joint_error_world_rad", "worst_joint", "end_effector_error_m")
        for s in ("", "_vs_mapped")
    }
    clock = {"upright_s", "fell_at_s", "target_fault_frames"}
    assert set(watched([0.93] * 4, 1).summary()) == errors | clock | {"wrist_lag_s", "wrist_path_ratio"}
