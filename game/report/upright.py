"""Upright time by the strict rule of thesis 4.4."""

FALLEN_SHARE = 0.8
TARGET_LOW, TARGET_HIGH = 0.35, 1.25


class UprightClock:
    """The character is upright while its COM height is at least 80 % of its target's; the first violation ends the count for good.

    A target whose own COM height leaves 0.35 to 1.25 of standing is a fault of the target and counted apart.
    """

    def __init__(self, standing_com_height: float) -> None:
        self._standing = standing_com_height
        self.upright_s = 0.0
        self.fell_at_s: float | None = None
        self.target_fault_frames = 0

    @property
    def upright(self) -> bool:
        return self.fell_at_s is None

    def observe(self, time_s: float, com_height: float, target_com_height: float) -> None:
        """Heights in metres at `time_s` seconds after the hang, called once a frame."""
        if not TARGET_LOW * self._standing <= target_com_height <= TARGET_HIGH * self._standing:
            self.target_fault_frames += 1
        if self.fell_at_s is not None:
            return
        # asked this way round, a height that is not a number counts as fallen
        if com_height >= FALLEN_SHARE * target_com_height:
            self.upright_s = time_s
        else:
            self.fell_at_s = time_s
