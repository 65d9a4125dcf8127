"""Whether the hands do what the player's hands do: how late, and how much of the way."""

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import END_EFFECTOR_PARTS, END_EFFECTORS
from game.compiled import compiled
from game.report.tracking_error import PosedBody, in_heading
from game.target.kinematic_target import KinematicTarget

Floats = NDArray[np.float64]

WRISTS = np.array([i for i, name in enumerate(END_EFFECTORS) if name.startswith("wrist")])
HANDS = np.array(END_EFFECTOR_PARTS)[WRISTS]
LONGEST_LAG_S = 0.5


@compiled
def places_in_heading(places: Floats, chosen: NDArray[np.int64], root_position: Floats, root_orientation: Floats) -> Floats:
    """(3 k,) the k chosen of `places` (n, 3), relative to the root and its heading."""
    return in_heading(places[chosen], root_position, root_orientation).reshape(-1)


class WristFollowing:
    """Samples the wrists, relative to the root, of the character and of the mapped input."""

    def __init__(self, rate_hz: float) -> None:
        self._rate_hz = rate_hz
        self._own: list[Floats] = []
        self._input: list[Floats] = []

    def sample(self, body: PosedBody, target: KinematicTarget) -> None:
        self._own.append(places_in_heading(body.joint, HANDS, body.joint[0], body.orientation[0]))
        mapped = target.mapped
        self._input.append(places_in_heading(mapped.end_effector, WRISTS, mapped.root_position, mapped.root_orientation))

    def lag_s(self) -> float | None:
        """The delay at which the wrists' velocities correlate best with the input's, by a parabola through the peak."""
        if len(self._own) < 3 * LONGEST_LAG_S * self._rate_hz:
            return None
        own, seen = (np.diff(np.array(rows), axis=0) for rows in (self._own, self._input))
        own, seen = own - own.mean(axis=0), seen - seen.mean(axis=0)
        longest = int(LONGEST_LAG_S * self._rate_hz)
        count = len(own) - 2 * longest
        middle = seen[longest : longest + count]
        score = np.array([float(np.sum(middle * own[longest + k : longest + k + count])) for k in range(-longest, longest + 1)])
        k = int(np.argmax(score))
        if score[k] <= 0.0:
            return None
        shift = 0.0
        if 0 < k < len(score) - 1:
            a, b, c = score[k - 1 : k + 2]
            shift = 0.5 * (a - c) / (a - 2.0 * b + c) if a - 2.0 * b + c < 0.0 else 0.0
        return float((k - longest + shift) / self._rate_hz)

    def path_ratio(self) -> float | None:
        """Length of the wrists' way over the length of the input's."""
        if len(self._own) < 2:
            return None
        lengths = []
        for rows in (self._own, self._input):
            steps = np.diff(np.array(rows), axis=0).reshape(-1, len(HANDS), 3)
            lengths.append(float(np.sqrt(np.sum(steps * steps, axis=2)).sum()))
        return lengths[0] / lengths[1] if lengths[1] > 0.0 else None
