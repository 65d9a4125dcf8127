"""Where nobody names a quality, the machine decides: what draws in software draws little."""

from types import SimpleNamespace
from typing import Any

import pytest

from game import picture
from game.tunables import Settings


@pytest.mark.parametrize(
    ("asked", "card", "drawn"),
    [
        (None, "llvmpipe (LLVM 15.0.6, 256 bits)", "low"),
        (None, "NVIDIA GeForce GTX 1050/PCIe/SSE2", "high"),
        ("high", "llvmpipe (LLVM 15.0.6, 256 bits)", "high"),
        ("medium", "NVIDIA GeForce GTX 1050/PCIe/SSE2", "medium"),
    ],
)
def test_the_quality_is_the_players_or_else_the_machines(monkeypatch: pytest.MonkeyPatch, asked: str | None, card: str, drawn: str) -> None:
    monkeypatch.setattr("game.render.renderer.Renderer", lambda ctx, quality, settings: quality)
    window: Any = SimpleNamespace(ctx=SimpleNamespace(info={"GL_RENDERER": card}))
    assert picture._renderer(window, asked, Settings()) == drawn
