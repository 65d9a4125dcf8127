"""Finding Kinects: which parts belong together, and which libusb is asked."""

import builtins
from typing import Any

import numpy as np
import pytest
import usb.backend.libusb1

from kinect.device_calibration import TYPICAL
from kinect.usb.discovery import find_kinects
from kinect.usb.errors import Fault, KinectError
from kinect.usb.libusb import load_backend
from kinect.usb.models import Model
from kinect.usb.simulated_clock import VirtualClock
from kinect.usb.simulated_host import SimulatedHost
from kinect.usb.simulated_kinect import OtherDevice, SimulatedKinect
from kinect.usb.simulated_libusb import simulated_backend
from kinect.usb.simulated_room import Room


def bus(*plugged: SimulatedKinect) -> Any:
    """A backend on a bus with these."""
    host = SimulatedHost(VirtualClock())
    for kinect in plugged:
        host.plug(kinect)
    return simulated_backend(host)


def test_the_parts_of_two_kinects_are_told_apart_by_their_port_paths() -> None:
    later, earlier = SimulatedKinect(ports=(5, 2)), SimulatedKinect(ports=(1,), model=Model.XBOX_1473)
    third = SimulatedKinect(ports=(5, 3), model=Model.WINDOWS_1517)
    found = find_kinects(bus(later, earlier, third))
    assert [k.model for k in found.kinects] == [Model.XBOX_1473, Model.XBOX_1414, Model.WINDOWS_1517]
    assert [k.place for k in found.kinects] == ["bus 1, port 1.1", "bus 1, port 5.2.1", "bus 1, port 5.3.1"]
    assert found.kinects[0].motor is None and found.kinects[2].motor is None
    for kinect in found.kinects:
        assert kinect.audio.port_numbers[:-1] == kinect.camera.port_numbers[:-1]
    assert found.kinects[1].motor.port_numbers == (5, 2, 2)
    assert found.powerless == () and found.first() is found.kinects[0]


def test_a_kinect_without_its_supply_beside_one_with_it_is_named_too() -> None:
    found = find_kinects(bus(SimulatedKinect(ports=(3,), powered=False), SimulatedKinect(ports=(6,))))
    assert len(found.kinects) == 1 and found.powerless == ("bus 1, port 3.2",)


def test_a_kinect_v1_is_taken_even_where_a_newer_one_stands_beside_it() -> None:
    found = find_kinects(bus(OtherDevice(0x02C4), SimulatedKinect()))
    assert found.newer == (Fault.KINECT_V2,) and found.first().model is Model.XBOX_1414


def test_where_the_system_tells_no_ports_the_bus_must_do(monkeypatch: pytest.MonkeyPatch) -> None:
    backend = bus(SimulatedKinect())
    monkeypatch.setattr(backend.lib, "libusb_get_port_numbers", lambda device, out, size: 0)
    kinect = find_kinects(backend).first()
    assert kinect.motor is not None and kinect.audio is not None and kinect.place == "bus 1"


def test_looking_at_the_real_bus_of_this_machine_raises_nothing() -> None:
    try:
        backend = load_backend()
    except KinectError as error:
        pytest.skip(str(error))
    find_kinects(backend)


def test_where_the_system_has_no_libusb_the_wheels_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []

    def get_backend(find_library: Any = None) -> Any:
        asked.append(find_library)
        return "the wheel's" if find_library else None

    monkeypatch.setattr(usb.backend.libusb1, "get_backend", get_backend)
    assert load_backend() == "the wheel's"
    assert asked[0] is None and asked[1]("usb-1.0").endswith(("libusb-1.0.so", "libusb-1.0.dylib", "libusb-1.0.dll"))


def test_where_there_is_no_libusb_at_all_one_sentence_tells_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    real = builtins.__import__

    def without_wheel(name: str, *rest: Any, **more: Any) -> Any:
        if name == "libusb_package":
            raise ImportError(name)
        return real(name, *rest, **more)

    monkeypatch.setattr(usb.backend.libusb1, "get_backend", lambda find_library=None: None)
    monkeypatch.setattr(builtins, "__import__", without_wheel)
    with pytest.raises(KinectError, match="pip install libusb-package") as caught:
        load_backend()
    assert caught.value.fault is Fault.NO_LIBUSB


def test_the_simulated_room_is_seen_at_its_true_distances() -> None:
    room = Room(valid=1.0)
    raw = room.disparity(0).astype(float)
    m = (raw / 4 - TYPICAL.const_shift - 0.375) * TYPICAL.zero_plane_pixel_size_m
    z = TYPICAL.zero_plane_distance_m * TYPICAL.baseline_m / (TYPICAL.baseline_m - m)
    seen = raw < 2047
    assert seen.mean() > 0.98 and (raw[:, 632:] == 2047).all()
    np.testing.assert_allclose(z[seen], room.depth(0)[seen], atol=0.025)
    assert z[100, 20] == pytest.approx(3.8, abs=0.03), "the wall"
    assert z[470, 20] == pytest.approx(0.9 * 575.8 / 230, abs=0.02), "the floor"
