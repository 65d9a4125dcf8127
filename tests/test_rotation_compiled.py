"""Single rotations in compiled loops are those of the arrays of rotations."""

import numpy as np
import pytest

from game import rotation
from game import rotation_compiled as one


@pytest.mark.parametrize("angle_rad", [0.0, 1e-9, 0.3, 3.0, np.pi - 1e-6])
def test_the_turn_from_one_orientation_to_another_is_the_logarithm_of_their_difference(angle_rad):
    rng = np.random.default_rng(5)
    for _ in range(20):
        axis = rotation.normalise(rng.normal(size=3))
        start = rotation.normalise(rng.normal(size=4))
        end = rotation.multiply(start, rotation.exp(angle_rad * axis))
        np.testing.assert_allclose(one.turn_to(start, end), angle_rad * axis, atol=1e-9)
        np.testing.assert_allclose(one.turn_to(start, -end), angle_rad * axis, atol=1e-9)
        np.testing.assert_array_equal(one.turn_to(start, end), one.log(one.multiply(one.conjugate(start), end)))
