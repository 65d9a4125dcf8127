"""The floor in a depth picture, by RANSAC over small flat pieces that face up."""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kinect.body import Floats, Floor
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.disparity import InverseDepth, inverse_depth
from kinect.depth.floor_evidence import objection
from kinect.depth.level_plane import LevelPlane, heights, refitted, tolerance
from kinect.depth.patches import Patches, patches_of

PATCH_LEAN: Final = float(np.cos(np.radians(16.0)))  # one piece's normal is good to a few degrees
LEAN_WITH_GRAVITY: Final = float(np.cos(np.radians(5.0)))  # the accelerometer's own error reaches 3 degrees
LEAN_WITHOUT_GRAVITY: Final = float(np.cos(np.radians(32.0)))  # the motor reaches 27 degrees
HYPOTHESES: Final = 250
JURY: Final = 600  # pieces that judge each hypothesis
PLANES_TRIED: Final = 4
FEWEST_PIECES: Final = 6
SHARES: Final = (1.0, 0.3, 0.12)  # of the tolerance: whole pieces are good to a tenth of a code
RIVALS: Final = 0.5  # a thick rug may show as much as the floor it lies on; crumbs of both that chance to align show less
KEPT: Final = 0.4  # a lens that bends the floor loses more to the strictest share, and is fitted with the one before
SENSOR_UP: Final = np.array([0.0, 1.0, 0.0])


@dataclass(frozen=True)
class FloorFinding:
    """floor: the plane in the sensor frame, or None; why: in words, what was found or why nothing counts as a floor.

    hint: where there is no floor, a level plane of which too little is seen to count as one; fit to draw by, no more.
    """

    floor: Floor | None
    why: str
    hint: Floor | None = None


def floor_in_frame(frame: DepthFrame, seed: int = 0) -> FloorFinding:
    """The floor in one depth picture, sought around the accelerometer's direction where there is one."""
    return find_floor(patches_of(frame), inverse_depth(frame.calibration), frame.up(), seed)


def find_floor(patches: Patches, constants: InverseDepth, up: Floats | None, seed: int = 0) -> FloorFinding:
    """The widest level plane with nothing below it, the lower of two alike; `up` (3,) is the unit direction against gravity, where known.

    The same pieces, up and seed give the same answer.
    """
    rng = np.random.default_rng(seed)
    towards = SENSOR_UP if up is None else up
    lean = LEAN_WITHOUT_GRAVITY if up is None else LEAN_WITH_GRAVITY
    with np.errstate(invalid="ignore"):
        below = patches.middle @ towards < 0.0
    free = patches.flat & below & (patches.normal @ towards > min(lean, PATCH_LEAN))
    floors: list[LevelPlane] = []
    small: list[LevelPlane] = []
    objections: list[str] = []
    for _ in range(PLANES_TRIED):
        plane = _widest_level(patches, constants, free, towards, lean, rng)
        if plane is None:
            break
        wrong = objection(patches, plane, constants)
        if wrong is None:
            floors.append(plane)
        else:
            objections.append(wrong.why)
            small += [plane] if wrong.small else []
        free = free & ~plane.members
    if floors:
        most = max(np.count_nonzero(plane.members) for plane in floors)
        wide = [plane for plane in floors if np.count_nonzero(plane.members) >= RIVALS * most]
        lowest = max(wide, key=lambda plane: plane.height_m)
        return FloorFinding(_floor(lowest), f"floor {lowest.height_m:.2f} m below the sensor")
    why = "no floor in view: " + (objections[0] if objections else "nothing level and wide is seen below the sensor")
    return FloorFinding(None, why, _floor(small[0]) if small else None)


def _floor(plane: LevelPlane) -> Floor:
    a, b, c = (float(v) for v in plane.normal)
    return Floor(a, b, c, plane.height_m)


def _widest_level(
    patches: Patches, constants: InverseDepth, free: NDArray[np.bool_], towards: Floats, lean: float, rng: np.random.Generator
) -> LevelPlane | None:
    """RANSAC, each time more strictly among what is left, so that a rug falls out; strict only where most pieces can follow."""
    plane: LevelPlane | None = None
    for share in SHARES:
        among = free if plane is None else plane.members
        best = _best_of_three(patches, constants, among, towards, lean, share, rng)
        stricter = None if best is None else refitted(patches, *best, among, constants, share)
        if stricter is None or (plane is not None and np.count_nonzero(stricter.members) < KEPT * np.count_nonzero(plane.members)):
            break
        plane = stricter
    return plane if plane is not None and float(plane.normal @ towards) > lean else None


def _best_of_three(
    patches: Patches,
    constants: InverseDepth,
    among: NDArray[np.bool_],
    towards: Floats,
    lean: float,
    share: float,
    rng: np.random.Generator,
) -> tuple[Floats, float] | None:
    """Normal (3,) and height of the plane through three pieces, within the lean, near which the pieces cover most of the room."""
    candidates = np.flatnonzero(among)
    if len(candidates) < FEWEST_PIECES:
        return None
    corners = patches.middle[rng.choice(candidates, size=(HYPOTHESES, 3))]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(across, axis=1)
    normals = across * (np.sign(across @ towards) / np.maximum(size, 1e-9))[:, None]
    usable = (size > 1e-3) & (normals @ towards > lean)
    if not np.any(usable):
        return None
    normals = normals[usable].T
    offsets = -np.einsum("ij,ji->i", corners[usable, 0], normals)
    if len(candidates) > JURY:
        candidates = rng.choice(candidates, JURY, replace=False)
    points = patches.middle[candidates]
    near = np.abs(heights(points, normals, offsets)) < share * tolerance(points, normals, constants)
    slant = -np.einsum("ij,ij->i", patches.normal[candidates], points) / np.linalg.norm(points, axis=1)
    covered = points[:, 2] ** 2 / np.maximum(slant, 0.1)  # what a piece's pixels cover of its surface, in proportion
    best = int(np.argmax(covered @ near))
    return normals[:, best], float(offsets[best])
