"""One line of the upright table: an input played once by one character with one strategy, measured by the strict rule of thesis 4.4."""

import traceback
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from game.characters.body_plan import load_body_plan
from game.commands import BadInput
from game.commands.casting import Casting
from game.physics.world import FRAME_HZ
from game.report.foot_slide import FootSlide
from game.report.observer import SAMPLE_HZ
from game.report.true_hands import ALLOWED_DELAY_S, TrueHands
from game.scenes.fighter import NoBodyError
from game.scenes.mirror import Mirror
from game.tunables import Settings, Value

Row = dict[str, Any]

MEASURES = (
    "upright_s",
    "fell_at_s",
    "target_fault_frames",
    "joint_error_parent_rad",
    "joint_error_world_rad",
    "joint_error_parent_rad_vs_mapped",
    "joint_error_world_rad_vs_mapped",
    "end_effector_error_m",
    "end_effector_error_m_vs_mapped",
    "worst_joint",
    "worst_joint_vs_mapped",
    "wrist_lag_s",
    "wrist_path_ratio",
    "unexplained_force_max_n",
    "unexplained_torque_max_nm",
    "contact_partners",
    "friction_cone_excess_n",
    "pushes",
    "peak_torque_nm",
    "guard_actions",
    "guard_messages",
    "held_frames",
    "warnings",
    "state_sha256",
)
"""What a row takes over from the report of a session."""


@dataclass(frozen=True)
class Case:
    """What is played: an input spec, a character, a balance strategy, an IK method, a seed (None where nothing is random)."""

    input: str
    character: str
    strategy: str
    ik: str
    seed: int | None = None


def run_case(case: Case, values: Mapping[str, Value], whole: bool) -> Row:
    """The measured row. `values` are all tunables but strategy and IK; `whole` plays on after a fall.

    clip_s is what was to be played after the hang, share the part of it upright. An input that cannot be played gives a row
    with `failed`, one sentence; `timing` holds what depends on the machine, everything else repeats bit by bit.
    """
    settings = Settings({**values, "balance.strategy": case.strategy, "ik.method": case.ik})
    row: Row = dict(asdict(case))
    try:
        return row | _play(case, settings, whole)
    except (BadInput, NoBodyError) as fault:
        return row | {"failed": str(fault)}
    except Exception as fault:  # whatever breaks in one run must not take the others along
        return row | {"failed": f"{case.input} broke off: {type(fault).__name__}: {fault}", "traceback": traceback.format_exc()}


def _play(case: Case, settings: Settings, whole: bool) -> Row:
    scene = Casting(case.input, case.character, settings, case.seed or 0).scene("mirror")
    assert isinstance(scene, Mirror)
    try:
        scene.enter()
        if scene.endless:
            raise BadInput(f"{case.input} never ends, so it has no share of time upright; give a recording or a performer.")
        slide = FootSlide()
        hands = (
            TrueHands(case.input.removeprefix("performer:"), load_body_plan(case.character))
            if case.input.startswith("performer:")
            else None
        )
        while not scene.finished and (whole or scene.observer.upright.upright):
            scene.fixed_update()
            simulation = scene.simulation
            if simulation.frame > 0 and simulation.frame % (FRAME_HZ // SAMPLE_HZ) == 0 and scene.observer.upright.upright:
                slide.sample(simulation.time_s, simulation.world.characters[0])
                if hands is not None:
                    hands.sample(simulation.time_s, simulation.world.characters[0])
        report = scene.report()
    finally:
        scene.leave()
    clip_s, upright_s = report["clip_s"], report["upright_s"]
    assert isinstance(clip_s, float) and isinstance(upright_s, float)
    measured: Row = {"clip_s": clip_s, "share": min(1.0, upright_s / clip_s) if clip_s > 0.0 else 1.0}
    # the last frame may end a fraction of a frame after the recording
    measured |= {name: report[name] for name in MEASURES} | {"upright_s": min(upright_s, clip_s)}
    measured |= {"foot_slide_m_s": slide.speed_m_s, **_true_hands(hands)}
    return measured | {"timing": {name: report[name] for name in ("real_time_factor", "ms_per_frame")}}


def _true_hands(hands: TrueHands | None) -> Row:
    """Of a performer: when the wrists are closest to the clean performer's, and how close then, or at the longest allowed delay."""
    if hands is None:
        return {"hand_error_true_m": None, "hand_delay_s": None}
    delay_s = hands.best_delay_s()
    return {"hand_error_true_m": hands.error_m(min(delay_s, ALLOWED_DELAY_S)), "hand_delay_s": delay_s}
