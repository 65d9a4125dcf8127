"""The benchmark measures something; how fast this machine is, is no test."""

import re
import subprocess
import sys

from game.render.quality import usual_quality
from tests.render.test_import_order import ROOT


def test_a_short_measurement_prints_every_figure(window) -> None:
    words = [sys.executable, "-m", "game.render.benchmark", "low", "64x36", "8"]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert f"{window.ctx.info['GL_RENDERER']}, low, 64 x 36" in done.stdout
    figures = [float(number) for number in re.findall(r"([\d.]+) ms", done.stdout)]
    assert len(figures) == 7
    assert all(figure > 0.0 for figure in figures)


def test_software_starts_low_and_a_card_starts_high() -> None:
    assert usual_quality("llvmpipe (LLVM 15.0.6, 256 bits)") == "low"
    assert usual_quality("NVIDIA GeForce RTX 3060/PCIe/SSE2") == "high"
