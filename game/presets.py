"""Named sets of values for the method: the thesis as written, and ours."""

from collections.abc import Mapping

from game.tunables import TUNABLES, Settings, TunableError, Value

PRESETS: Mapping[str, Mapping[str, Value]] = {
    "default": {},
    "thesis": {
        "pd.gravity_feedforward": False,
        "pd.kp_hat": 800.0,
        "pd.ratio": "dynamic",
        "balance.strategy": "ankle",
        "duel.strategy": "ankle",
        "balance.ankle_clamp_rad": 0.034,
        "balance.w_vel": 0.4,
        "balance.w_com": 0.0,
        "ik.method": "dls",
        "ik.damping": 0.4,
        "ik.pose_weight": 1.0,
        "ik.target_clamp_m": 0.15,
        "intake.smoothing": 1.0,
        "gate.on": False,
        "control.rate_hz": "120",
    },
}
"""What each preset sets; every other tunable of the method goes back to its declared default."""

LOOK_GROUPS = frozenset({"picture", "layer"})
"""Groups a preset leaves alone: how the game looks is the player's own business."""


def method_names() -> tuple[str, ...]:
    """The tunables a preset decides, in the order of their declaration."""
    return tuple(name for name, t in TUNABLES.items() if t.group not in LOOK_GROUPS)


def apply_preset(settings: Settings, name: str) -> None:
    """Set every tunable of the method as preset `name` says; raises TunableError on an unknown name."""
    if name not in PRESETS:
        raise TunableError(f"there is no preset {name!r}; valid: {', '.join(PRESETS)}.")
    settings.reset(method_names())
    for tunable, value in PRESETS[name].items():
        settings.set(tunable, value)


def matching_preset(settings: Settings) -> str | None:
    """The preset whose values the settings hold right now, or None where a player has turned something."""
    for name, values in PRESETS.items():
        if all(settings.get(n) == values.get(n, TUNABLES[n].default) for n in method_names()):
            return name
    return None
