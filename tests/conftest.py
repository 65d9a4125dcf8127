"""What holds for all tests: property tests try the same examples every time, a slow machine is no failure, MuJoCo has nothing to say."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import settings

from game.physics.world import World

settings.register_profile("topple", derandomize=True, deadline=None)
settings.load_profile("topple")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Files with slow tests go first: begun last, one of them would be waited for with half of the computer idle."""
    slow = {item.path for item in items if item.get_closest_marker("slow") is not None}
    items.sort(key=lambda item: item.path not in slow)


@pytest.fixture(autouse=True)
def no_physics_warnings(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Fails a test in whose worlds MuJoCo warned of anything, or in which it left its log file behind."""
    worlds: list[World] = []
    make = World.__init__

    def make_and_remember(self: World, *args, **kwargs) -> None:
        worlds.append(self)
        make(self, *args, **kwargs)

    monkeypatch.setattr(World, "__init__", make_and_remember)
    log = Path.cwd() / "MUJOCO_LOG.TXT"
    log_was_there = log.exists()
    yield
    assert log_was_there or not log.exists(), "MuJoCo wrote MUJOCO_LOG.TXT into the current folder"
    if request.node.get_closest_marker("warnings_expected") is None:
        counts = [world.warnings for world in worlds if hasattr(world, "data")]
        assert sum(counts) == 0, f"MuJoCo warned {counts} times in this test's worlds"
