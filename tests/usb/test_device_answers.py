"""What the device tells of itself: calibration, level, tilt; and what some models cannot."""

import math
import struct

import pytest

from kinect.device_calibration import TYPICAL, DeviceCalibration
from kinect.usb.errors import Fault, KinectError
from kinect.usb.keep_alive import led_command
from kinect.usb.models import Model, model_of
from kinect.usb.motor import Led, no_motor, parse_state
from kinect.usb.read_calibration import parse_calibration
from kinect.usb.simulated_faults import simulate
from kinect.usb.simulated_kinect import SimulatedKinect
from kinect.usb.udev_rule import install_rule, rule_text
from tests.usb.simulated_sensor import bench


def fixed_block(baseline: float = 7.5, distance: float = 120.0, pixel: float = 0.1042, octets: int = 320) -> bytes:
    """The fixed parameters behind their error word."""
    return (bytes(92) + struct.pack("<4f", baseline, 2.3, distance, pixel)).ljust(octets, b"\0")


def test_four_floats_in_centimetres_and_a_shift_are_the_calibration() -> None:
    read = parse_calibration(fixed_block(7.45, 119.0, 0.1033), b"\xca\x00")
    assert read is not None and not read.is_typical
    assert (read.baseline_m, read.zero_plane_distance_m) == pytest.approx((0.0745, 1.19))
    assert (read.zero_plane_pixel_size_m, read.const_shift) == pytest.approx((0.001033, 202.0))
    assert read.focal_px == pytest.approx(576.0, abs=0.1)


def test_the_typical_focal_length_is_that_of_the_factory_model() -> None:
    assert TYPICAL.focal_px == pytest.approx(575.8, abs=0.05)


@pytest.mark.parametrize(
    "block", [fixed_block(octets=0)[:107], fixed_block(baseline=math.nan), fixed_block(distance=0.0), fixed_block(pixel=0.0)]
)
def test_nonsense_is_no_calibration(block: bytes) -> None:
    assert parse_calibration(block, b"\xc8\x00") is None


@pytest.mark.parametrize("octets", [108, 320, 332])
def test_replies_of_every_known_length_are_understood(octets: int) -> None:
    assert parse_calibration(fixed_block(octets=octets), b"\xc8\x00") is not None


def test_a_sensor_takes_the_calibration_of_the_device_it_opened() -> None:
    own = DeviceCalibration(1.19, 0.001033, 0.0745, 203.0)
    b = bench()
    b.simulation.kinect.camera.calibration = own
    b.run(0.2)
    assert b.sensor.calibration.zero_plane_distance_m == pytest.approx(1.19)
    assert b.sensor.calibration.const_shift == 203.0 and not b.sensor.calibration.is_typical
    b.sensor.close()


def test_ten_literal_octets_are_a_sensor_that_looks_up_by_thirteen_degrees() -> None:
    state = parse_state(bytes.fromhex("00 00 FF FE 03 24 00 C0 1A 00"))
    assert state.acceleration == pytest.approx((-2 / 819, 804 / 819, 192 / 819))
    assert math.degrees(state.pitch_rad) == pytest.approx(13.4, abs=0.05)
    assert state.motor_deg == 13.0 and not state.at_limit
    assert state.up is not None and sum(a * a for a in state.up) == pytest.approx(1.0)


def test_a_moving_motor_tells_no_angle_and_a_falling_sensor_no_up() -> None:
    state = parse_state(bytes.fromhex("00 00 00 00 00 10 00 00 80 04"))
    assert state.motor_deg is None and state.up is None


def test_a_cut_reply_of_the_motor_is_refused() -> None:
    with pytest.raises(KinectError, match="9 octets instead of 10"):
        parse_state(bytes(9))


def test_tilt_and_led_reach_the_motor_of_a_1414() -> None:
    b = bench()
    b.run(0.5, until=lambda: len(b.frames) > 0)
    b.sensor.set_tilt(-10.0)
    b.sensor.set_led(Led.RED)
    b.run(0.2)
    motor = b.simulation.kinect.motor
    assert (motor.half_degrees, motor.led) == (-20, 2)
    assert b.sensor.level is not None and b.sensor.level.pitch_rad == pytest.approx(0.0)
    b.sensor.close()


@pytest.mark.parametrize("fault", ["model-1473", "kinect-for-windows"])
def test_other_models_say_in_plain_words_that_they_cannot_tilt_and_give_depth(fault: str) -> None:
    b = bench(fault)
    assert b.run(1.0, until=lambda: len(b.frames) > 2)
    with pytest.raises(KinectError, match=r"firmware .* tilt it by hand") as caught:
        b.sensor.set_tilt(5.0)
    assert caught.value.fault is Fault.UNSUPPORTED and b.sensor.level is None
    assert b.simulation.kinect.audio.led == 3, "the LED was not set, so a newer one would leave the bus"
    b.sensor.close()


def test_a_kinect_for_windows_is_set_to_the_alternate_that_has_its_streams() -> None:
    b = bench("kinect-for-windows")
    b.run(0.5)
    assert b.simulation.kinect.camera.setting == 1
    b.sensor.close()


def test_the_led_of_a_1473_is_twenty_literal_octets() -> None:
    assert led_command(1) == bytes.fromhex("09200206 01000000 00000000 10000000 03000000")


def test_a_1414_without_its_motor_says_what_to_do() -> None:
    assert "was not found" in str(no_motor(Model.XBOX_1414))


def test_models_are_told_apart_by_product_and_release() -> None:
    assert [model_of(p, r) for p, r in [(0x02AE, 0x010B), (0x02AE, 0x0205), (0x02BF, 1), (0x02B0, 0x010B)]] == [
        Model.XBOX_1414,
        Model.XBOX_1473,
        Model.WINDOWS_1517,
        None,
    ]


def test_a_motor_refuses_angles_that_would_strain_it() -> None:
    b = bench()
    b.run(0.3)
    with pytest.raises(ValueError, match="-27 to 27 degrees, not 40"):
        b.sensor.set_tilt(40.0)
    b.run(0.1)
    assert b.simulation.kinect.motor.half_degrees == 0
    b.sensor.close()


def test_every_part_of_every_model_is_in_the_udev_rule(tmp_path) -> None:
    text = rule_text()
    for model in Model:
        for device in SimulatedKinect(model=model).devices:
            if device.device_class != 9:
                assert f'ATTR{{idProduct}}=="{device.product:04x}", TAG+="uaccess"' in text
    path = tmp_path / "70-kinect.rules"
    assert install_rule(path).startswith(f"Wrote {path}")
    assert path.read_text() == text
    assert "in place already" in install_rule(path)
    with pytest.raises(OSError, match="nowhere"):
        install_rule(tmp_path / "nowhere" / "rule")


def test_an_unknown_fault_is_refused_with_the_list_of_those_there_are() -> None:
    with pytest.raises(ValueError, match=r"no fault is called 'gremlins'.*permission"):
        simulate("gremlins")
