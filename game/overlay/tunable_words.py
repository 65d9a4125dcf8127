"""The words and number formats a tunable is shown with."""

import math
from functools import lru_cache

from game.tunables import Settings, Tunable

GROUP_TITLES = {
    "sensor": "Sensor model",
    "intake": "Intake",
    "ik": "Kinematic target",
    "pd": "PD control",
    "control": "Control rate",
    "balance": "Balance",
    "physics": "Physics",
    "picture": "Picture",
    "layer": "Layers",
}

_UNIT_SUFFIXES = ("_rad", "_deg", "_m", "_s", "_nm", "_n", "_hz", "_kg")


def group_title(group: str) -> str:
    """Heading of a group of tunables."""
    return GROUP_TITLES.get(group, group.replace("_", " ").capitalize())


@lru_cache(maxsize=512)
def label(tunable: Tunable) -> str:
    """`balance.ankle_clamp_rad` reads `ankle clamp`: the unit stands beside the number."""
    word = tunable.name.split(".", 1)[1]
    for suffix in _UNIT_SUFFIXES:
        if tunable.unit and word.endswith(suffix):
            word = word[: -len(suffix)]
            break
    return word.replace("_", " ")


def decimals(tunable: Tunable) -> int:
    """Digits after the point that tell apart about a thousandth of the range (of the low end, on a logarithmic slider)."""
    span = tunable.low if tunable.log and tunable.low > 0 else tunable.high - tunable.low
    extra = 1 if tunable.log else 2
    return max(0, min(6, extra - math.floor(math.log10(span)))) if span > 0 else 3


@lru_cache(maxsize=512)
def number_format(tunable: Tunable) -> str:
    """printf format with the unit."""
    unit = tunable.unit.replace("%", "%%")
    return f"%.{decimals(tunable)}f {unit}".rstrip()


def value_words(tunable: Tunable, value: object) -> str:
    """A value as the player reads it."""
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, (int, float)):
        return f"{value:.6g} {tunable.unit}".rstrip()
    return str(value)


def range_words(tunable: Tunable) -> str:
    """What is valid, in words."""
    if isinstance(tunable.default, bool):
        return "on or off"
    if tunable.choices:
        return ", ".join(tunable.choices)
    return f"{tunable.low:.6g} to {tunable.high:.6g} {tunable.unit}".rstrip() + (" (logarithmic)" if tunable.log else "")


def command_words(tunable: Tunable, settings: Settings) -> str:
    """How to set the current value on the command line."""
    value = settings.get(tunable.name)
    word = str(value).lower() if isinstance(value, bool) else f"{value:.6g}" if isinstance(value, float) else value
    return f"--set {tunable.name}={word}"


def matches(tunable: Tunable, wanted: str) -> bool:
    """Does the filter text occur in the tunable's name, heading or meaning? Every word of it must."""
    text = f"{tunable.name} {label(tunable)} {group_title(tunable.group)} {tunable.meaning}".lower()
    return all(word in text for word in wanted.lower().split())


def rounded(tunable: Tunable, value: float) -> float:
    """A slider works in single precision: give back the short decimal it meant, within the range."""
    return min(tunable.high, max(tunable.low, float(f"{value:.6g}")))
