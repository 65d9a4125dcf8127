"""A read-only view of one character's dynamics, for control, scenes and reports. World frame, SI units."""

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import DOF_COUNT, FEET, PARENT, PART_COUNT
from game.compiled import compiled

Floats = NDArray[np.float64]
Indices = NDArray[np.int32]

_PARENT = np.array(PARENT)

POSITION_COUNT = 63
"""Root position 3 and quaternion 4, fourteen joint quaternions."""

CONTACT_HEIGHT_M = 0.004
"""A foot whose lowest corner is below this stands on the floor."""

_CORNERS = np.array([[x, y, -1.0] for x in (-1.0, 1.0) for y in (-1.0, 1.0)] + [[x, y, 1.0] for x in (-1.0, 1.0) for y in (-1.0, 1.0)])


class BodyDynamics:
    """Character `index` of a world. `refresh` after the world's kinematics have been brought up to date."""

    def __init__(self, model: mj.MjModel, data: mj.MjData, plan: BodyPlan, index: int) -> None:
        self._model, self._data, self.plan = model, data, plan
        self.index = index
        first = 1 + PART_COUNT * index
        self.root_body = first
        self.bodies = slice(first, first + PART_COUNT)
        self.dofs = slice(DOF_COUNT * index, DOF_COUNT * (index + 1))
        self.joint_dofs = slice(DOF_COUNT * index + 6, DOF_COUNT * (index + 1))
        self.coordinates = slice(POSITION_COUNT * index, POSITION_COUNT * (index + 1))
        self.subtree_mass: Floats = np.array(model.body_subtreemass[self.bodies])
        self.foot_half: Floats = plan.size[list(FEET)] / 2.0
        # views: MuJoCo steps in place
        self._position, self._velocity = data.qpos[self.coordinates], data.qvel[self.dofs]
        self._turn, self._orientation = data.xmat[self.bodies].reshape(-1, 3, 3), data.xquat[self.bodies]
        self._joint, self._box_centre = data.xpos[self.bodies], data.xipos[self.bodies]
        self._subtree_com, self._gravity = data.subtree_com[self.bodies], model.opt.gravity
        self._rotation = self._position[7:].reshape(-1, 4)
        self._sparse_mass = data.M, model.M_rownnz, model.M_rowadr, model.M_colind
        self.refresh()

    def refresh(self) -> None:
        """Copy what the last kinematics pass left in the data, and forget what was derived from older states."""
        self.orientation: Floats = self._orientation.copy()
        self.turn: Floats = self._turn.copy()
        self.joint: Floats = self._joint.copy()
        self.box_centre: Floats = self._box_centre.copy()
        self.subtree_com: Floats = self._subtree_com.copy()
        self.com: Floats = self.subtree_com[0]
        self._com_velocity: Floats | None = None
        self._foot_contact: tuple[bool, bool] | None = None
        self._equations: tuple[Floats, Floats] | None = None

    @property
    def gravity(self) -> float:
        """m/s^2, positive."""
        return -float(self._gravity[2])

    @property
    def held(self) -> bool:
        """Its root is held by the start-up hang."""
        return bool(self._data.eq_active[self.index])

    @property
    def configuration(self) -> Floats:
        """(63,) qpos of this character."""
        return self._position.copy()

    @property
    def velocity(self) -> Floats:
        """(48,) qvel: root linear (world), root angular (root frame), joints (child frames)."""
        return self._velocity.copy()

    @property
    def joint_rotation(self) -> Floats:
        """(14, 4) child in parent frame."""
        return self._rotation.copy()

    @property
    def equations(self) -> tuple[Floats, Floats]:
        """Mass matrix (48, 48) and bias forces (48,) of the state at the last refresh."""
        if self._equations is None:
            model, data = self._model, self._data
            mj.mj_crb(model, data)
            mj.mj_comVel(model, data)
            bias = np.empty(model.nv)
            mj.mj_rne(model, data, 0, bias)
            self._equations = dense_mass(*self._sparse_mass, self.dofs.start), bias[self.dofs]
        return self._equations

    @property
    def com_jacobian(self) -> Floats:
        """(3, 48) of the centre of mass."""
        full = np.empty((3, self._model.nv))
        mj.mj_jacSubtreeCom(self._model, self._data, full, self.root_body)
        return full[:, self.dofs]

    @property
    def com_velocity(self) -> Floats:
        """(3,) m/s."""
        if self._com_velocity is None:
            self._com_velocity = mean_velocity(self._velocity, self.turn, self.joint, self.box_centre, self.plan.mass)
        return self._com_velocity

    @property
    def root_spin(self) -> Floats:
        """(3,) rad/s, angular velocity of the pelvis, world frame."""
        return self.turn[0] @ self._velocity[3:6]

    @property
    def mass_matrix(self) -> Floats:
        """(48, 48)"""
        full = np.empty((self._model.nv, self._model.nv))
        mj.mj_fullM(self._model, self._data, full)
        return full[self.dofs, self.dofs]

    @property
    def bias(self) -> Floats:
        """(48,) Coriolis, centrifugal and gravity forces."""
        return self._data.qfrc_bias[self.dofs].copy()

    @property
    def foot_corners(self) -> Floats:
        """(2, 8, 3) corners of the left and right foot box."""
        feet = list(FEET)
        local = self.foot_half[:, None, :] * _CORNERS
        return self.box_centre[feet][:, None, :] + local @ self.turn[feet].transpose(0, 2, 1)

    @property
    def foot_contact(self) -> tuple[bool, bool]:
        """Left, right foot: lowest corner below 4 mm."""
        if self._foot_contact is None:
            self._foot_contact = feet_on_floor(self.turn, self.box_centre, self.foot_half)
        return self._foot_contact

    def com_height(self) -> float:
        return float(self.com[2])


@compiled
def lowest_corner(turn: Floats, centre: Floats, half: Floats) -> float:
    """Height (m) of a box's lowest corner: its centre less its half extent along the vertical; turn (3, 3), half (3,)."""
    return centre[2] - abs(turn[2, 0]) * half[0] - abs(turn[2, 1]) * half[1] - abs(turn[2, 2]) * half[2]


@compiled
def lowest_corners(turn: Floats, box_centre: Floats, half: Floats) -> tuple[float, float]:
    """Height (m) of the lowest corner of the left and of the right foot; turn (15, 3, 3), box_centre (15, 3), half (2, 3) m."""
    left, right = FEET
    return lowest_corner(turn[left], box_centre[left], half[0]), lowest_corner(turn[right], box_centre[right], half[1])


@compiled
def feet_on_floor(turn: Floats, box_centre: Floats, half: Floats) -> tuple[bool, bool]:
    """Left, right: lowest corner of the foot below 4 mm; turn (15, 3, 3), box_centre (15, 3), half (2, 3) m."""
    left, right = lowest_corners(turn, box_centre, half)
    return left < CONTACT_HEIGHT_M, right < CONTACT_HEIGHT_M


@compiled
def dense_mass(mass: Floats, row_count: Indices, row_start: Indices, column: Indices, first: int) -> Floats:
    """(48, 48) of the character whose rows begin at `first`, from MuJoCo's rows: what lies on and left of the diagonal."""
    out = np.zeros((DOF_COUNT, DOF_COUNT))
    for row in range(DOF_COUNT):
        start = row_start[first + row]
        for at in range(start, start + row_count[first + row]):
            other = column[at] - first
            out[row, other] = mass[at]
            out[other, row] = mass[at]
    return out


@compiled
def mean_velocity(velocity: Floats, turn: Floats, joint: Floats, box_centre: Floats, mass: Floats) -> Floats:
    """(3,) m/s of the centre of mass: the mean of the parts' velocities by mass; velocity (48,), mass (15,), the rest as `BodyDynamics`."""
    spin, at_joint = np.zeros((PART_COUNT, 3)), np.empty((PART_COUNT, 3))
    out, arm, at_centre, total = np.zeros(3), np.empty(3), np.empty(3), 0.0
    at_joint[0] = velocity[:3]
    for part in range(PART_COUNT):
        parent = _PARENT[part]
        if part > 0:
            spin[part], at_joint[part] = spin[parent], at_joint[parent]
            for axis in range(3):
                arm[axis] = joint[part, axis] - joint[parent, axis]
            one.add_cross(at_joint[part], spin[parent], arm)
        one.add_turned(spin[part], turn[part], velocity[3 + 3 * part : 6 + 3 * part])
        for axis in range(3):
            arm[axis] = box_centre[part, axis] - joint[part, axis]
        at_centre[:] = at_joint[part]
        one.add_cross(at_centre, spin[part], arm)
        for axis in range(3):
            out[axis] += mass[part] * at_centre[axis]
        total += mass[part]
    return out / total
