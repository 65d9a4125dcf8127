"""The start-up hang (thesis 4.1): each character is held upright just above the floor while it takes up its first pose."""

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import ANKLES, FEET
from game.target.forward_kinematics import pose_skeleton

Floats = NDArray[np.float64]

HANG_S = 1.0
SOLE_CLEARANCE_M = 0.02


def hanging_root(plan: BodyPlan, place_xy: Floats, root_orientation: Floats, joint_rotation: Floats) -> tuple[Floats, Floats]:
    """Root position (3,) and orientation (4,) for the hang: the pose's own, tilted so that its COM stands over its feet.

    The lowest corner of the feet, taken flat as the balance strategy will hold them, is 2 cm above the floor.
    """
    feet = list(FEET)
    origin = np.zeros(3)
    upright = root_orientation
    for _ in range(3):
        pose = pose_skeleton(plan, origin, upright, joint_rotation)
        stand = pose.joint[feet].mean(axis=0) + rotation.turn(rotation.matrix(rotation.about_z(rotation.yaw(upright))), _sole_centre(plan))
        rise = pose.centre_of_mass(plan) - stand
        if rise[2] < 0.3 * plan.idle_com_height:
            break
        upright = rotation.multiply(rotation.between(rotation.normalise(rise), np.array([0.0, 0.0, 1.0])), upright)
    pose = pose_skeleton(plan, origin, upright, joint_rotation)
    sole = pose.joint[feet, 2].min() - plan.joint[feet[0], 2]
    return np.array([*place_xy, SOLE_CLEARANCE_M - float(sole)]), rotation.normalise(upright)


def level_feet(plan: BodyPlan, root_orientation: Floats, joint_rotation: Floats) -> Floats:
    """The pose (14, 4) with the feet level, each ahead of its own shank: sensed feet may point through the floor."""
    shank = pose_skeleton(plan, np.zeros(3), root_orientation, joint_rotation).orientation[np.array(FEET) - 1]
    level = joint_rotation.copy()
    for ankle, turn in zip(ANKLES, shank, strict=True):
        level[ankle] = rotation.multiply(rotation.conjugate(turn), rotation.about_z(rotation.yaw(turn)))
    return level


def _sole_centre(plan: BodyPlan) -> Floats:
    """(3,) from the ankle to the foot's box centre, level."""
    offset = plan.centre_offset[FEET[0]].copy()
    offset[1:] = 0.0
    return offset


def hold_root(model: mj.MjModel, data: mj.MjData, index: int, position: Floats, orientation: Floats) -> None:
    """Weld the root of character `index` to a place in the world; the weld is stated and off from the release on."""
    weld = model.equality(f"c{index}.hang").id
    # MuJoCo's order: the point in body 2 (the world), the point in body 1 (the pelvis), body 2's orientation in body 1. The points
    # lie in the pelvis: held at the world's origin instead, a turn by a hundredth of a radian would shift it by centimetres
    model.eq_data[weld, 0:3] = position
    model.eq_data[weld, 3:6] = 0.0
    model.eq_data[weld, 6:10] = rotation.conjugate(orientation)
    model.eq_data[weld, 10] = 1.0
    data.eq_active[weld] = 1


def release_root(model: mj.MjModel, data: mj.MjData, index: int) -> None:
    """Let character `index` go: gravity and the floor have it from now on."""
    data.eq_active[model.equality(f"c{index}.hang").id] = 0
