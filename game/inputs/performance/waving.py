"""Waving (thesis Table 1: upper body motion): the right hand overhead, then both."""

from game.inputs.performance.curves import Curve, swing, total
from game.inputs.performance.script import Script, from_idle

LENGTH_S = 12.1
WAVES_HZ = 1.15


def script() -> Script:
    return Script(
        LENGTH_S,
        {
            **_arm("right", 0.8, 10.9, WAVES_HZ),
            **_arm("left", 5.2, 10.9, WAVES_HZ),
            "trunk.roll": total(swing(1.5, 5.8, -1.0, WAVES_HZ), from_idle("trunk.roll", (0.8, 0), (1.8, -3), (5.0, -3), (6.2, 0))),
            "head.yaw": from_idle("head.yaw", (0.8, 0), (1.6, -6), (5.2, -6), (6.0, 6), (9.0, 6), (10.4, 0)),
            "zmp.y": from_idle("zmp.y", (0.7, 0), (1.8, -0.015), (5.0, -0.015), (6.2, 0)),
        },
    )


def _arm(side: str, start: float, end: float, hertz: float) -> dict[str, Curve]:
    """Raised beside the head within a second, the forearm swinging about the elbow and the whole arm a little with it."""
    up, down = start + 1.0, end - 1.1
    return {
        f"{side}.side": total(
            from_idle(f"{side}.side", (start, 0), (up, 88), (down, 88), (end, 6)), swing(up - 0.3, down + 0.3, -13, hertz)
        ),
        f"{side}.twist": from_idle(f"{side}.twist", (start, 0), (up, 84), (down, 84), (end, 0)),
        f"{side}.flex": from_idle(f"{side}.flex", (start, 0), (up, 14), (down, 14), (end, 0)),
        f"{side}.elbow": total(
            from_idle(f"{side}.elbow", (start, 0), (up, 82), (down, 82), (end, 0)), swing(up - 0.3, down + 0.3, -50, hertz)
        ),
    }
