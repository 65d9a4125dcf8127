"""In the mirror the hand on your side of the glass moves."""

import numpy as np

from game.intake.mirror import mirror
from kinect.body import BONES, Joint

JOINTS = np.random.default_rng(1).normal(size=(7, 20, 3))


def test_mirroring_twice_changes_nothing():
    np.testing.assert_array_equal(mirror(mirror(JOINTS)), JOINTS)


def test_the_raised_left_hand_becomes_a_raised_right_hand_on_the_other_side():
    seen = mirror(JOINTS)
    np.testing.assert_array_equal(seen[:, Joint.WRIST_RIGHT], JOINTS[:, Joint.WRIST_LEFT] * [1.0, -1.0, 1.0])
    np.testing.assert_array_equal(seen[:, Joint.HEAD], JOINTS[:, Joint.HEAD] * [1.0, -1.0, 1.0])


def test_bones_keep_their_lengths():
    swap = {j: Joint[j.name.replace("LEFT", "?").replace("RIGHT", "LEFT").replace("?", "RIGHT")] for j in Joint}
    for a, b in BONES:
        there = np.linalg.norm(mirror(JOINTS)[:, a] - mirror(JOINTS)[:, b], axis=1)
        np.testing.assert_allclose(there, np.linalg.norm(JOINTS[:, swap[a]] - JOINTS[:, swap[b]], axis=1))
