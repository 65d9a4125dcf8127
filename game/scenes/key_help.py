"""The puppet's keys as a player reads them on screen."""

PUPPET_KEYS: tuple[tuple[str, str], ...] = (
    ("Arrows", "lean"),
    ("A D", "thrust a fist"),
    ("Q E", "raise an arm"),
    ("F", "guard"),
    ("S", "crouch"),
    ("Z X", "step"),
    ("C V", "kick"),
    ("W", "wave"),
    ("Space", "jump"),
)
"""(keys, what they do); every key of `game.inputs.puppet_controls.KEYS` is among them."""


def keys_for(input_name: str) -> tuple[tuple[str, str], ...]:
    """The keys to show for an input: those of the puppet where keys steer it, else none."""
    return PUPPET_KEYS if input_name in ("puppet", "auto") else ()
