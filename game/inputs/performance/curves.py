"""Smooth functions of time: what a script is written in. All are C2 and accept arrays of times (s)."""

import itertools
from collections.abc import Callable

import numpy as np

from kinect.body import Floats

Curve = Callable[[Floats], Floats]


def ease(t: Floats, start: float, end: float) -> Floats:
    """0 before start, 1 after end, between them the minimum-jerk quintic (Flash & Hogan 1985)."""
    u = np.clip((t - start) / (end - start), 0.0, 1.0)
    return u * u * u * (10.0 + u * (6.0 * u - 15.0))


def keys(*pairs: tuple[float, float]) -> Curve:
    """Through (time, value) pairs, at rest in each; constant outside. Times must increase."""
    times = [time for time, _ in pairs]
    if not pairs or any(b <= a for a, b in itertools.pairwise(times)):
        raise ValueError(f"Key times must increase, not {times}.")

    def curve(t: Floats) -> Floats:
        value = np.full(np.shape(t), float(pairs[0][1]))
        for (start, a), (end, b) in itertools.pairwise(pairs):
            if a != b:
                value = value + (b - a) * ease(t, start, end)
        return value

    return curve


def bump(start: float, end: float, height: float) -> Curve:
    """Rises from 0 to height half way and falls back, C2 at both ends."""

    def curve(t: Floats) -> Floats:
        u = np.clip((t - start) / (end - start), 0.0, 1.0)
        return height * (4.0 * u * (1.0 - u)) ** 3

    return curve


def swing(start: float, end: float, amplitude: float, hertz: float, fade_s: float = 0.6, phase: float = 0.0) -> Curve:
    """A sine that fades in after start and out before end; phase in turns."""

    def curve(t: Floats) -> Floats:
        envelope = ease(t, start, start + fade_s) - ease(t, end - fade_s, end)
        return amplitude * envelope * np.sin(2.0 * np.pi * (hertz * (t - start) + phase))

    return curve


def total(*parts: Curve) -> Curve:
    """The sum of curves."""
    return lambda t: np.sum([part(t) for part in parts], axis=0)


def through(*knots: tuple[float, float, float, float]) -> Curve:
    """Through (time, value, rate, second rate) knots by quintics, C2; constant outside. A parabola comes out exact."""

    def curve(t: Floats) -> Floats:
        value = np.where(t < knots[0][0], knots[0][1], knots[-1][1])
        for (start, *before), (end, *after) in itertools.pairwise(knots):
            inside = (t >= start) & (t <= end)
            value = np.where(inside, _quintic((t - start) / (end - start), end - start, before, after), value)
        return value

    return curve


def _quintic(u: Floats, span: float, before: list[float], after: list[float]) -> Floats:
    p0, v0, a0 = before[0], before[1] * span, before[2] * span**2
    p1, v1, a1 = after[0] - (p0 + v0 + a0 / 2.0), after[1] * span - (v0 + a0), after[2] * span**2 - a0
    rest = (10.0 * p1 - 4.0 * v1 + a1 / 2.0) * u**3 + (-15.0 * p1 + 7.0 * v1 - a1) * u**4 + (6.0 * p1 - 3.0 * v1 + a1 / 2.0) * u**5
    return p0 + v0 * u + a0 / 2.0 * u * u + rest
