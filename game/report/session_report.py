"""The report of a session: what every scene with characters measures, ready for JSON."""

import platform
import time
from importlib.metadata import PackageNotFoundError, version

import mujoco
import numpy as np

from game.characters.skeleton import JOINTS
from game.physics.world import FRAME_HZ
from game.scenes.simulation import Simulation
from game.tunables import Settings


class Stopwatch:
    """Process CPU seconds since it was made: the cost of the whole chain, other programs left out."""

    def __init__(self) -> None:
        self._start = time.process_time()

    def cpu_s(self) -> float:
        return time.process_time() - self._start


def peak_torques(simulation: Simulation, index: int) -> dict[str, float]:
    """Largest torque of each joint so far, N m: the largest of its three axes."""
    body = simulation.world.characters[index]
    peak = simulation.world.peak_torque[body.joint_dofs].reshape(-1, 3).max(axis=1)
    return dict(zip(JOINTS, map(float, peak), strict=True))


def simulation_report(simulation: Simulation, settings: Settings, watch: Stopwatch, seed: int) -> dict[str, object]:
    """Honesty, speed, guard, state hash, versions and settings."""
    world = simulation.world
    frames = max(1, simulation.frames_run)
    simulated = frames / FRAME_HZ
    return {
        "simulated_s": max(0.0, simulation.clock_s),
        "unexplained_force_max_n": float(world.meter.unexplained_force_n.max()),
        "unexplained_torque_max_nm": float(world.meter.unexplained_torque_nm.max()),
        "contact_partners": world.meter.partners,
        "friction_cone_excess_n": world.meter.worst_cone_excess_n,
        "pushes": world.stated_pushes,
        "real_time_factor": simulated / max(watch.cpu_s(), 1e-9),
        "ms_per_frame": {stage: 1e3 * spent / frames for stage, spent in simulation.stage_s.items()},
        "guard_actions": world.guard_actions,
        "guard_messages": world.faults,
        "held_frames": sum(f.intake.held_frames for f in simulation.fighters),
        "warnings": world.warnings,
        "state_sha256": world.state_sha256,
        "seed": seed,
        "versions": versions(),
        "settings": settings.as_dict(),
    }


def versions() -> dict[str, str]:
    """Of Topple, Python and what computes the result."""
    try:
        own = version("topple")
    except PackageNotFoundError:
        own = "checkout"
    return {
        "topple": own,
        "python": platform.python_version(),
        "mujoco": mujoco.__version__,
        "numpy": np.__version__,
        "machine": platform.machine(),
    }
