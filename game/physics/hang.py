"""The start-up hang (thesis 4.1): each character is held upright just above the floor while it takes up its first pose."""

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import FEET
from game.target.forward_kinematics import pose_skeleton

Floats = NDArray[np.float64]

HANG_S = 1.0
SOLE_CLEARANCE_M = 0.02

_CORNERS = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])


def hanging_root(plan: BodyPlan, place_xy: Floats, heading_rad: float, joint_rotation: Floats) -> tuple[Floats, Floats]:
    """Root position (3,) and upright orientation (4,) with the lowest corner of the feet 2 cm above the floor."""
    orientation = rotation.about_z(heading_rad)
    pose = pose_skeleton(plan, np.array([*place_xy, 0.0]), orientation, joint_rotation)
    centres = pose.box_centres(plan)
    feet = list(FEET)
    corners = centres[feet][:, None, :] + (plan.size[feet][:, None, :] / 2.0 * _CORNERS) @ pose.turn[feet].transpose(0, 2, 1)
    return np.array([*place_xy, SOLE_CLEARANCE_M - float(corners[..., 2].min())]), orientation


def hold_root(model: mj.MjModel, data: mj.MjData, index: int, position: Floats, orientation: Floats) -> None:
    """Weld the root of character `index` to a place in the world; the weld is stated and off from the release on."""
    weld = model.equality(f"c{index}.hang").id
    inverse = rotation.conjugate(orientation)
    # relpose of a weld is body 2 (the world) in the frame of body 1 (the pelvis)
    model.eq_data[weld, 0:3] = 0.0
    model.eq_data[weld, 3:6] = rotation.rotate(inverse, -position)
    model.eq_data[weld, 6:10] = inverse
    model.eq_data[weld, 10] = 1.0
    data.eq_active[weld] = 1


def release_root(model: mj.MjModel, data: mj.MjData, index: int) -> None:
    """Let character `index` go: gravity and the floor have it from now on."""
    data.eq_active[model.equality(f"c{index}.hang").id] = 0
