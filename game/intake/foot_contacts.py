"""What the player's feet do in one frame: the word between the input gate and whoever keeps a balance."""

from dataclasses import dataclass


@dataclass(frozen=True)
class FootContacts:
    """Contacts of the player's feet, left and right of the frame they belong to (mirrored with it).

    left_planted, right_planted: on the floor; flight: both are off it in a jump. lift_left_m, lift_right_m: height of each foot above
    its rest, metres, never negative. known: False while the sensor does not show the legs (a bow); the feet then stay as they were.
    """

    left_planted: bool = True
    right_planted: bool = True
    flight: bool = False
    lift_left_m: float = 0.0
    lift_right_m: float = 0.0
    known: bool = True

    @property
    def planted(self) -> tuple[bool, bool]:
        """(left, right)."""
        return self.left_planted, self.right_planted


STANDING = FootContacts()
"""Both feet on the floor."""
