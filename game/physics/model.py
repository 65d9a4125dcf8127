"""The MuJoCo model of a floor and one or more box characters, through MjSpec."""

from collections.abc import Sequence

import mujoco as mj

from game.characters.body_plan import BodyPlan
from game.characters.skeleton import FEET, JOINTS, PARENT, PARTS

FLOOR_BIT = 1
INTEGRATORS = {
    "discrete": mj.mjtIntegrator.mjINT_DISCRETE,
    "implicitfast": mj.mjtIntegrator.mjINT_IMPLICITFAST,
    "euler": mj.mjtIntegrator.mjINT_EULER,
    "explicit": mj.mjtIntegrator.mjINT_EULER,
}


def build_model(plans: Sequence[BodyPlan], *, step_s: float, integrator: str, friction: float, self_collision: bool) -> mj.MjModel:
    """A floor and the characters, named `c0.pelvis`, `c1.pelvis` ...; bodies, joints and DOFs in the order of `PARTS`.

    Characters collide with the floor and with each other; with their own parts only if `self_collision`.
    """
    # MuJoCo would print each warning and write MUJOCO_LOG.TXT into the current folder; the world counts them instead
    mj.set_mju_user_warning(_already_counted)
    spec = mj.MjSpec()
    spec.option.timestep = step_s
    spec.option.integrator = INTEGRATORS[integrator]
    # the momentum balance of the honesty meter needs the contact solve to converge to rounding. Tolerance 1e-12 leaves up to 3e-4 N
    # in single steps, 1e-16 up to 4e-6 N between two fighters, 1e-20 less than 1e-8, all at the same cost; the elliptic cone leaves 4e-3 N
    spec.option.tolerance = 1e-20
    spec.option.cone = mj.mjtCone.mjCONE_PYRAMIDAL
    # a failed step must show, not silently restart the world
    spec.option.disableflags |= mj.mjtDisableBit.mjDSBL_AUTORESET
    if len(plans) > 1:
        # a warm start is taken or refused for all characters at once: what one does would change the last bits of the others
        spec.option.disableflags |= mj.mjtDisableBit.mjDSBL_WARMSTART
    else:
        # one body is one island, and looking for it takes a tenth of the step; of two, each is to be solved as if it were alone
        spec.option.disableflags |= mj.mjtDisableBit.mjDSBL_ISLAND
    if integrator == "explicit":
        spec.option.disableflags |= mj.mjtDisableBit.mjDSBL_EULERDAMP
    spec.worldbody.add_geom(
        name="floor",
        type=mj.mjtGeom.mjGEOM_PLANE,
        size=[20, 20, 1],
        friction=[friction, 0.005, 0.0001],
        contype=FLOOR_BIT,
        conaffinity=0,
        solref=SOLREF,
    )
    for index, plan in enumerate(plans):
        _add_character(spec, plan, index, len(plans), friction, self_collision)
    return spec.compile()


SOLREF = [0.0045, 1.0]
"""MuJoCo's contact parameters: what touches is pushed out in 4.5 ms, critically damped; two steps of 1/480 s is the least it takes."""

LIMB_SHARE = 0.5
"""Limbs and trunk, in clothes, rub on each other and on an opponent's this share as hard as soles do; on the floor as hard as soles."""

SKIN_M = 0.01
"""What comes to the floor is caught this much before it, and what comes down fast earlier: see `floor_skin`. Feet are bare."""


def _already_counted(_text: str) -> None:
    """MuJoCo's warnings stand in `MjData.warning`."""


def _add_character(spec: mj.MjSpec, plan: BodyPlan, index: int, count: int, friction: float, self_collision: bool) -> None:
    own = FLOOR_BIT << (index + 1)
    others = sum(FLOOR_BIT << (i + 1) for i in range(count) if i != index)
    touches = FLOOR_BIT | others | (own if self_collision else 0)
    bodies = []
    for part, name in enumerate(PARTS):
        parent = spec.worldbody if part == 0 else bodies[PARENT[part]]
        place = plan.joint[0] if part == 0 else plan.joint_offset[part]
        body = parent.add_body(name=f"c{index}.{name}", pos=place)
        if part == 0:
            body.add_freejoint(name=f"c{index}.root")
        else:
            body.add_joint(name=f"c{index}.{JOINTS[part - 1]}", type=mj.mjtJoint.mjJNT_BALL)
        body.add_geom(
            name=f"c{index}.{name}",
            type=mj.mjtGeom.mjGEOM_BOX,
            pos=plan.centre_offset[part],
            size=plan.size[part] / 2.0,
            mass=plan.mass[part],
            friction=[(1.0 if part in FEET else LIMB_SHARE) * friction, 0.005, 0.0001],
            contype=own,
            conaffinity=touches,
            solref=SOLREF,
        )
        bodies.append(body)
        if part not in FEET:
            _add_skin(spec, index, name, friction)
    hang = spec.add_equality(name=f"c{index}.hang", type=mj.mjtEq.mjEQ_WELD, objtype=mj.mjtObj.mjOBJ_BODY)
    hang.name1 = f"c{index}.pelvis"
    hang.active = False
    hang.solref = [0.01, 1.0]


def skin_name(index: int, part: str) -> str:
    """Of the contact between the floor and a part of character `index`."""
    return f"c{index}.{part}.skin"


def _add_skin(spec: mj.MjSpec, index: int, part: str, friction: float) -> None:
    pair = spec.add_pair(name=skin_name(index, part))
    pair.geomname1, pair.geomname2 = "floor", f"c{index}.{part}"
    pair.margin = SKIN_M
    pair.condim = 3
    pair.friction = [friction, friction, 0.005, 0.0001, 0.0001]
    pair.solref = SOLREF
