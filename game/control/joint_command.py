"""What control hands to physics, and what a balance strategy is."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from game.characters.body_plan import BodyPlan
from game.target.kinematic_target import KinematicTarget

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class JointCommand:
    """Targets and gains of the fourteen ball joints, held until the next control tick; child frame.

    rotation (14, 4) child in parent; velocity (42,) rad/s; kp (42,) N m/rad; kd (42,) N m s/rad; feedforward (42,) N m.
    """

    rotation: Floats
    velocity: Floats
    kp: Floats
    kd: Floats
    feedforward: Floats


class BodyState(Protocol):
    """What control may read of one character; physics implements it as `BodyDynamics`. World frame, SI units."""

    orientation: Floats
    """(15, 4) of the parts."""
    turn: Floats
    """(15, 3, 3) the same as matrices, part to world."""
    joint: Floats
    """(15, 3) joint centres, row 0 the root point."""
    box_centre: Floats
    """(15, 3)"""
    com: Floats
    subtree_com: Floats
    """(15, 3) centre of mass of each part with all that hangs on it."""
    subtree_mass: Floats
    """(15,)"""
    plan: BodyPlan

    @property
    def joint_rotation(self) -> Floats:
        """(14, 4) child in parent frame."""
        ...

    @property
    def velocity(self) -> Floats:
        """(48,) root linear (world), root angular (root frame), joints (child frames)."""
        ...

    @property
    def equations(self) -> tuple[Floats, Floats]:
        """Mass matrix (48, 48) and bias forces (48,) of the present state."""
        ...

    @property
    def held(self) -> bool:
        """Its root is held by the start-up hang."""
        ...

    @property
    def com_velocity(self) -> Floats:
        """(3,) m/s, of the centre of mass."""
        ...

    @property
    def root_spin(self) -> Floats:
        """(3,) rad/s, angular velocity of the pelvis, world frame."""
        ...

    @property
    def foot_contact(self) -> tuple[bool, bool]:
        """Left, right foot on the floor."""
        ...

    @property
    def gravity(self) -> float:
        """m/s^2, positive."""
        ...


class BalanceStrategy(Protocol):
    """How a character turns a kinematic target into joint commands. Exchangeable live."""

    def reset(self, dynamics: BodyState) -> None:
        """Forget everything; called at the start and when the strategy is exchanged."""
        ...

    def command(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> JointCommand:
        """The command until the next control tick, `dt` seconds away."""
        ...
