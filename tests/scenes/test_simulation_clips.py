"""Every recording that lies beside the project: two seconds of it through the whole chain, finite, honest and without a warning."""

from pathlib import Path

import numpy as np
import pytest

from game.characters.body_plan import load_body_plan
from game.inputs.open_input import open_input
from game.scenes.fighter import Fighter
from game.scenes.simulation import HANG_FRAMES, Simulation
from game.tunables import Settings

CLIPS = Path(__file__).resolve().parents[2] / ".." / "shared" / "data" / "clips"
FILES = sorted(CLIPS.glob("*.npz"))

pytestmark = pytest.mark.shared_data


@pytest.mark.skipif(not FILES, reason=f"no recordings in {CLIPS}")
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_recording_moves_the_character_honestly(path: Path):
    settings = Settings()
    fighter = Fighter(0, load_body_plan("original"), lambda: open_input(f"clip:{path}"), settings, mirrored=True)
    simulation = Simulation([fighter], settings)
    for _ in range(HANG_FRAMES + 120):
        simulation.advance()
    world = simulation.world
    assert np.isfinite(world.data.qpos).all() and np.isfinite(world.data.qvel).all()
    assert world.warnings == 0 and world.guard_actions == 0, world.faults
    assert world.meter.unexplained_force_n[0] < 1e-6 and world.meter.unexplained_torque_nm[0] < 1e-6
    assert world.meter.worst_cone_excess_n <= 1e-9
    assert world.stated_pushes == [] and world.meter.partners == ["floor - c0"]
    assert fighter.frames_seen > 30
    simulation.close()
