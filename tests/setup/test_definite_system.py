"""Small definite systems are solved as LAPACK solves them, near singular ones too."""

import numpy as np
import pytest

from game.definite_system import solve_definite


@pytest.mark.parametrize("count", [1, 2, 15, 19])
@pytest.mark.parametrize("ridge", [1.0, 1e-9])
def test_the_solution_solves_the_system(count: int, ridge: float) -> None:
    rng = np.random.default_rng(count)
    factor = rng.normal(size=(count, 2 * count))
    system, wanted = factor @ factor.T + ridge * np.eye(count), rng.normal(size=count)
    solved = system @ wanted
    solve_definite(system.copy(), solved)
    np.testing.assert_allclose(solved, wanted, rtol=1e-8, atol=1e-8)


def test_only_the_lower_triangle_is_read() -> None:
    system, solved = np.array([[4.0, np.nan], [2.0, 3.0]]), np.array([8.0, 10.0])
    solve_definite(system, solved)
    np.testing.assert_allclose(solved, [0.5, 3.0], atol=1e-15)


def test_a_system_that_is_all_but_singular_stays_finite() -> None:
    along = np.array([1.0, 2.0, -1.0])
    solved = along.copy()
    solve_definite(np.outer(along, along) + 1e-10 * np.eye(3), solved)
    np.testing.assert_allclose(solved, along / 6.0, rtol=1e-4)
