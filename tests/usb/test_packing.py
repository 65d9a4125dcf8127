"""Eleven-bit pixels: by hand, and there and back."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinect.usb.packing import pack11, unpack11

BY_HAND = [
    ([2047, 0, 0, 0, 0, 0, 0, 0], "FF E0 00 00 00 00 00 00 00 00 00"),
    ([0, 0, 0, 0, 0, 0, 0, 2047], "00 00 00 00 00 00 00 00 00 07 FF"),
    ([0, 0, 2047, 0, 0, 0, 0, 0], "00 00 03 FF 80 00 00 00 00 00 00"),
    ([1, 2, 3, 4, 5, 6, 7, 8], "00 20 08 01 80 40 0A 01 80 38 08"),
    ([0x400, 1, 0x400, 1, 0x400, 1, 0x400, 1], "80 00 06 00 00 18 00 00 60 00 01"),
]


@pytest.mark.parametrize(("pixels", "octets"), BY_HAND)
def test_octets_written_out_by_hand_are_these_pixels(pixels: list[int], octets: str) -> None:
    packed = np.frombuffer(bytes.fromhex(octets), np.uint8)
    assert unpack11(packed).tolist() == pixels
    assert pack11(np.array(pixels, np.uint16)).tobytes() == packed.tobytes()


@given(st.lists(st.integers(0, 2047), min_size=8, max_size=8))
def test_packing_is_the_number_in_base_2048(pixels: list[int]) -> None:
    number = sum(pixel << 11 * (7 - i) for i, pixel in enumerate(pixels))
    assert pack11(np.array(pixels, np.uint16)).tobytes() == number.to_bytes(11, "big")


def test_a_whole_picture_comes_back_unchanged() -> None:
    picture = np.random.default_rng(7).integers(0, 2048, (480, 640), np.uint16)
    packed = pack11(picture)
    assert packed.size == 422_400
    np.testing.assert_array_equal(unpack11(packed).reshape(480, 640), picture)


def test_octets_of_all_ones_are_pixels_without_data() -> None:
    assert set(unpack11(np.full(22, 0xFF, np.uint8)).tolist()) == {2047}


def test_what_cannot_be_pixels_is_refused() -> None:
    with pytest.raises(ValueError, match="groups of 11 octets"):
        unpack11(np.zeros(12, np.uint8))
    with pytest.raises(ValueError, match="groups of 8"):
        pack11(np.zeros(7, np.uint16))
    with pytest.raises(ValueError, match=r"0\.\.2047.*2048"):
        pack11(np.full(8, 2048, np.uint16))
