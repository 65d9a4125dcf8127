"""The option --set NAME=VALUE, which several commands take any number of times."""

from collections.abc import Iterable

from game.commands import BadInput
from game.tunables import Settings


def apply_assignments(settings: Settings, assignments: Iterable[str]) -> None:
    """Set every NAME=VALUE; raises BadInput where one has not that form, TunableError where a tunable refuses it."""
    for assignment in assignments:
        name, equals, value = assignment.partition("=")
        if not equals:
            raise BadInput(f"--set {assignment!r} must have the form NAME=VALUE, such as ik.damping=0.3.")
        settings.set(name.strip(), value.strip())
