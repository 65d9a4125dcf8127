"""The last states of a world, for rolling a failed step back and for looking at what led to it."""

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

CONTENT = int(mj.mjtState.mjSTATE_INTEGRATION)


class StateRing:
    """Keeps the newest `length` integration states of one MjData."""

    def __init__(self, model: mj.MjModel, data: mj.MjData, length: int = 480) -> None:
        self._model, self._data = model, data
        self._states = list(np.empty((length, mj.mj_stateSize(model, CONTENT))))
        self._taken = 0

    def __len__(self) -> int:
        return min(self._taken, len(self._states))

    def push(self) -> None:
        """Remember the present state."""
        mj.mj_getState(self._model, self._data, self._states[self._taken % len(self._states)], CONTENT)
        self._taken += 1

    def state(self, ago: int = 0) -> Floats:
        """The state remembered `ago` pushes before the newest."""
        if not 0 <= ago < len(self):
            raise IndexError(f"only {len(self)} states are remembered, not {ago + 1}")
        return self._states[(self._taken - 1 - ago) % len(self._states)]

    def restore(self, ago: int = 0) -> None:
        """Set the world back to a remembered state and forget the newer ones."""
        mj.mj_setState(self._model, self._data, self.state(ago), CONTENT)
        self._taken -= ago
