"""Inverses of the end-effector Jacobian with null-space pose tracking: pseudoinverse, damped and selectively damped least squares."""

import math
from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled
from game.definite_system import solve_definite

Floats = NDArray[np.float64]

SINGULAR = 1e-10
"""Regularisation of J J^T, so that exactly stretched limbs leave the pseudoinverse defined (m^2/rad^2)."""

SDLS_MAX_ANGLE_RAD = np.pi / 4.0
"""gamma_max of Buss & Kim 2005: the largest turn of any axis in one step towards the end-effectors' targets."""


@compiled
def damped_least_squares(jacobian: Floats, error: Floats, pose_error: Floats, damping: float, pose_weight: float) -> Floats:
    """Joint increments (n,) rad for end-effector errors (m,) m and pose errors phi (n,) rad, Eq. 3.5.

    J+ e + w (phi - J+ J phi) with J+ = J^T (J J^T + lambda^2 I)^-1 of Eq. 3.3; neither J+ nor the projector is formed.
    """
    rows, columns = jacobian.shape
    step, left = pose_weight * pose_error, error.copy()
    gram = np.zeros((rows, rows))
    for i in range(rows):
        for k in range(columns):
            left[i] -= jacobian[i, k] * step[k]
    for k in range(columns):
        # an axis moves few of the end-effectors: those down its own limb
        for i in range(rows):
            moved = jacobian[i, k]
            if moved != 0.0:
                for j in range(i + 1):
                    gram[i, j] += moved * jacobian[j, k]
    for i in range(rows):
        gram[i, i] += damping * damping + SINGULAR
    solve_definite(gram, left)
    for i in range(rows):
        for k in range(columns):
            step[k] += jacobian[i, k] * left[i]
    return step


def pseudoinverse(jacobian: Floats, error: Floats, pose_error: Floats, damping: float, pose_weight: float) -> Floats:
    """Eq. 3.2 with the null-space term of Eq. 3.5: damped least squares without damping."""
    return damped_least_squares(jacobian, error, pose_error, 0.0, pose_weight)


def _clamp_largest(step: Floats, limit: float) -> Floats:
    largest = float(np.max(np.abs(step), initial=0.0))
    return step if largest <= limit else step * (limit / largest)


def selectively_damped(jacobian: Floats, error: Floats, pose_error: Floats, damping: float, pose_weight: float) -> Floats:
    """Selectively damped least squares (Buss & Kim 2005), with the undamped null-space projection of the pose error.

    Each singular vector's step is limited by how far it would throw the end-effectors against how far they need to go.
    """
    u, sigma, vt = np.linalg.svd(jacobian, full_matrices=False)
    # rho[j, k]: how far joint axis j moves end-effector k per radian; each end-effector has three rows
    columns = jacobian.reshape(-1, 3, jacobian.shape[1])
    reach = np.sqrt(np.sum(columns * columns, axis=1))
    step = np.zeros(jacobian.shape[1])
    for i, s in enumerate(sigma):
        if s < 1e-6:
            continue
        along = float(u[:, i] @ error)
        moved = float(np.sum(np.sqrt(np.sum(u[:, i].reshape(-1, 3) ** 2, axis=1))))
        thrown = float(np.sum(np.abs(vt[i]) * reach)) / s
        limit = SDLS_MAX_ANGLE_RAD * min(1.0, moved / max(thrown, 1e-12))
        step += _clamp_largest(vt[i] * (along / s), limit)
    step = _clamp_largest(step, SDLS_MAX_ANGLE_RAD)
    rank = sigma > 1e-6
    row_space = vt[rank]
    return step + pose_weight * (pose_error - row_space.T @ (row_space @ pose_error))


Solver = Callable[[Floats, Floats, Floats, float, float], Floats]

SOLVERS: Mapping[str, Solver] = {
    "pseudoinverse": pseudoinverse,
    "dls": damped_least_squares,
    "sdls": selectively_damped,
}
"""ik.method to its solver; "none" takes the mapped pose as it is."""


@compiled
def clamp_targets(error: Floats, limit_m: float) -> Floats:
    """Each end-effector's error (k, 3) shortened to at most `limit_m` (D_max of Buss & Kim 2005)."""
    out = np.empty_like(error)
    for k in range(len(error)):
        x, y, z = error[k]
        out[k] = error[k] * min(1.0, limit_m / max(math.sqrt(x * x + y * y + z * z), 1e-12))
    return out
