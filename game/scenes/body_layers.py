"""A fighter as things to draw: its boxes, the target's ghost, the sensed joints, balance, contacts, torque."""

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.skeleton import FEET, JOINTS, PARENT
from game.control.whole_body.support_polygon import convex_hull
from game.drawables import Boxes, Capsules, Drawable, Layer, Lines
from game.physics.dynamics import BodyDynamics
from game.scenes.costume import dressed, tint
from game.scenes.depth_layer import depth_points
from game.scenes.fighter import Fighter
from game.scenes.simulation import Simulation
from game.target.forward_kinematics import PosedSkeleton, pose_skeleton
from game.target.mapping import map_positions
from game.tunables import Settings
from kinect.body import BONES

Floats = NDArray[np.float64]

GHOST = np.array([0.35, 0.75, 1.0, 1.0])
MAPPED = np.array([1.0, 0.6, 0.3, 1.0])
SENSED = np.array([0.95, 0.85, 0.25, 1.0])
FULL_TORQUE_NM = 150.0
NEWTONS_PER_METRE = 1500.0


def blended(before: tuple[Floats, Floats], after: tuple[Floats, Floats], blend: float) -> tuple[Floats, Floats]:
    """Positions and orientations `blend` of the way between two states; normalised linear interpolation."""
    position = before[0] + blend * (after[0] - before[0])
    same_side = np.where(np.sum(before[1] * after[1], axis=1, keepdims=True) < 0.0, -after[1], after[1])
    return position, rotation.normalise(before[1] + blend * (same_side - before[1]))


def fighter_layers(simulation: Simulation, index: int, blend: float, settings: Settings) -> list[Layer]:
    """Every layer of fighter `index` that is switched on, world frame."""
    fighter = simulation.fighters[index]
    body = simulation.world.characters[index]
    position, orientation = blended(simulation.previous[index], simulation.current[index], blend)
    colours = torque_colours(simulation, fighter) if settings.switch("layer.torque") else None
    layers = [Layer(f"fighter{index}", dressed(fighter.plan, position, orientation, index, colours))]
    anchor = _anchor(fighter, body)
    layers += depth_points(fighter.source, settings, fighter.mirrored, anchor)
    if settings.switch("layer.target"):
        layers.append(Layer("target", (ghost(fighter.plan, _placed(fighter.target.pose, anchor)),), opacity=0.35))
    if settings.switch("layer.input") and fighter.frame is not None:
        layers.append(Layer("input", sensed_joints(fighter, anchor + np.array([0.0, 0.9, 0.0]))))
    if settings.switch("layer.orientation"):
        layers.append(Layer("orientation", (orientation_skeleton(fighter, anchor + np.array([0.0, -0.9, 0.0])),), opacity=0.6))
    if settings.switch("layer.balance"):
        layers.append(Layer("balance", balance_marks(fighter, body)))
    if settings.switch("layer.contact"):
        layers.append(Layer("contact", contact_arrows(simulation, index)))
    return layers


def _anchor(fighter: Fighter, body: BodyDynamics) -> Floats:
    """From where the target stands to where the character does, on the floor."""
    between_feet = body.joint[list(FEET)].mean(axis=0) - fighter.target.pose.joint[list(FEET)].mean(axis=0)
    return np.array([between_feet[0], between_feet[1], 0.0])


def _placed(pose: PosedSkeleton, offset: Floats) -> PosedSkeleton:
    return PosedSkeleton(pose.turn, pose.joint + offset, pose.root_orientation, pose.joint_rotation)


def ghost(plan, pose: PosedSkeleton) -> Boxes:
    """The kinematic target as pale boxes."""
    count = len(plan.mass)
    return Boxes(pose.box_centres(plan), pose.orientation, plan.size / 2.0, np.tile(GHOST, (count, 1)), casts_shadow=False)


def sensed_joints(fighter: Fighter, offset: Floats) -> tuple[Drawable, ...]:
    """The input's twenty joints as spheres and its nineteen bones, beside the character (thesis Fig. 4, right)."""
    assert fighter.frame is not None
    joints = map_positions(fighter.frame.raw, fighter.calibration) + offset
    bones = np.array(BONES)
    colour = np.tile(SENSED, (len(joints), 1))
    return (
        Capsules(joints, joints, np.full(len(joints), 0.045), colour, casts_shadow=False),
        Capsules(joints[bones[:, 0]], joints[bones[:, 1]], np.full(len(bones), 0.016), colour[: len(bones)] * 0.8, casts_shadow=False),
    )


def orientation_skeleton(fighter: Fighter, offset: Floats) -> Boxes:
    """The input's orientations on the character's skeleton, unprocessed (thesis Fig. 4, middle)."""
    mapped = fighter.target.mapped
    pose = pose_skeleton(fighter.plan, mapped.root_position + offset, mapped.root_orientation, mapped.joint_rotation)
    boxes = ghost(fighter.plan, pose)
    return Boxes(boxes.position, boxes.orientation, boxes.half_size, np.tile(MAPPED, (len(boxes.position), 1)), casts_shadow=False)


def support_polygon(body: BodyDynamics) -> Floats:
    """(n, 2) convex hull, seen from above, of the sole corners that touch the floor; empty in flight."""
    corners = body.foot_corners.reshape(-1, 3)
    touching = np.round(corners[corners[:, 2] < 0.008][:, :2], 6)
    return convex_hull(touching) if len(touching) > 2 else touching


def balance_marks(fighter: Fighter, body: BodyDynamics) -> tuple[Drawable, ...]:
    """Support polygon, COM and its plumb line, COS and COM target as marks on the floor."""
    hull = support_polygon(body)
    marks: list[Drawable] = []
    if len(hull) > 2:
        ring = np.column_stack((hull, np.full(len(hull), 0.006)))
        sides = np.stack((ring, np.roll(ring, -1, axis=0)), axis=1)
        marks.append(Lines(sides, np.tile([0.2, 1.0, 0.4, 1.0], (len(ring), 1)), 3.0, on_top=True))
    ground = body.com * np.array([1.0, 1.0, 0.0])
    marks.append(Lines(np.stack((body.com, ground))[None], np.array([[1.0, 1.0, 1.0, 0.8]]), 1.5, on_top=True))
    spots = [(ground, (1.0, 1.0, 1.0, 1.0)), (body.com, (1.0, 1.0, 1.0, 1.0))]
    cos = getattr(fighter.strategy, "cos", None)
    goal = getattr(fighter.strategy, "com_target", None)
    if cos is not None and goal is not None:
        spots += [(cos * np.array([1.0, 1.0, 0.0]), (0.2, 1.0, 0.4, 1.0)), (goal * np.array([1.0, 1.0, 0.0]), (1.0, 0.35, 0.2, 1.0))]
    places = np.array([place for place, _ in spots])
    colours = np.array([colour for _, colour in spots])
    marks.append(Capsules(places, places, np.full(len(spots), 0.022), colours, emission=0.6, casts_shadow=False))
    return tuple(marks)


def contact_arrows(simulation: Simulation, index: int) -> tuple[Drawable, ...]:
    """The force of each contact on character `index`, 1 m to 1500 N."""
    found = simulation.world.meter.contacts
    if found is None:
        return ()
    sign = found.on_characters(len(simulation.fighters))[index]
    mine = sign != 0.0
    if not mine.any():
        return ()
    start = found.point[mine]
    end = start + sign[mine, None] * found.force[mine] / NEWTONS_PER_METRE
    colour = np.tile([1.0, 0.45, 0.1, 1.0], (int(mine.sum()), 1))
    return (Capsules(start, end, np.full(len(start), 0.009), colour, emission=0.5, casts_shadow=False),)


def torque_colours(simulation: Simulation, fighter: Fighter) -> Floats:
    """(15, 4) from blue (idle) over yellow to red (150 N m): each part shows the joint that carries it, the pelvis its hips."""
    torque = simulation.world.actuation.torque[fighter.dofs()][6:].reshape(-1, 3)
    size = np.sqrt(np.sum(torque * torque, axis=1))
    load = np.concatenate(([max(size[JOINTS.index("hip_left")], size[JOINTS.index("hip_right")])], size)) / FULL_TORQUE_NM
    assert len(load) == len(PARENT)
    return tint(np.clip(load, 0.0, 1.0))
