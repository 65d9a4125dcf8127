"""The ring keeps listening: under long holds of the interpreter lock, after errors, and beside controls that cannot."""

import array
import errno
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import usb.backend.libusb1
import usb.core

from kinect.usb import opened_kinect
from kinect.usb.assembler import Assembler
from kinect.usb.claim import claim_camera, let_go
from kinect.usb.command import CameraCommands
from kinect.usb.counters import new_tally
from kinect.usb.discovery import find_kinects
from kinect.usb.errors import Fault, KinectError
from kinect.usb.iso_read_threads import IsoReadThreads, slot_lengths
from kinect.usb.packet import DEPTH_11
from kinect.usb.pyusb_names import LIBRARY_NAMES, MODULE_NAMES, NamesMissing, PyusbInside, inside
from kinect.usb.ring import IsoRing, RingSize
from kinect.usb.sensor import KinectSensor
from kinect.usb.sensor_options import SensorOptions
from kinect.usb.simulated_clock import VirtualClock
from kinect.usb.simulated_faults import Simulation, simulate
from kinect.usb.simulated_libusb import in_use, misuse
from kinect.usb.simulated_stream import replayed
from kinect.usb.stream_registers import DEPTH_ENDPOINT, START_DEPTH, write_all
from tests.usb.simulated_sensor import PICTURES, Bench, bench

CALLBACK_S = 0.0005  # what a transfer of 64 packets costs this reader, generously


def frames_sent(b: Bench) -> int:
    """Whole frames that the simulated camera has put on the wire."""
    return b.simulation.kinect.camera.streams[DEPTH_ENDPOINT].frames_sent(int(b.clock.now() * 8000))


def test_the_names_inside_pyusb_are_there() -> None:
    assert usb.__version__ == "1.3.1"
    module: Any = usb.backend.libusb1
    for name in MODULE_NAMES:
        assert hasattr(module, name), f"pyusb's libusb1 has no {name} any more"
    for field in ("dev_handle", "endpoint", "status", "actual_length", "callback", "buffer", "num_iso_packets", "iso_packet_desc"):
        assert hasattr(module._libusb_transfer, field)
    assert [name for name, _ in module._libusb_iso_packet_descriptor._fields_] == ["length", "actual_length", "status"]
    assert hasattr(usb.core._ResourceManager, "managed_open")
    backend = usb.backend.libusb1.get_backend()
    if backend is None:
        pytest.skip("no libusb on this machine to look into")
    missing = [name for name in LIBRARY_NAMES if not hasattr(backend.lib, name)]
    assert not missing and hasattr(backend, "ctx")


def test_the_real_librarys_transfers_are_laid_out_as_the_ring_reads_them() -> None:
    module: Any = usb.backend.libusb1
    backend = module.get_backend()
    if backend is None:
        pytest.skip("no libusb on this machine to ask")
    ring = IsoRing.__new__(IsoRing)
    ring.size, ring._endpoint = RingSize(1, 64), DEPTH_ENDPOINT
    ring._callback = module._libusb_transfer_cb_fn_p(lambda transfer: None)
    ring._inside = PyusbInside(backend.lib, backend.ctx, None, module)
    slot = ring._make(1920)
    assert slot.data.shape == (64, 1920) and (slot.descriptors["length"] == 1920).all()
    slot.descriptors["actual"] = np.arange(64)
    transfer = slot.transfer.contents
    assert [d.actual_length for d in module._get_iso_packet_list(transfer)] == list(range(64))
    assert (transfer.type, transfer.num_iso_packets, transfer.length, transfer.buffer) == (1, 64, 64 * 1920, slot.data.ctypes.data)
    backend.lib.libusb_free_transfer(slot.transfer)


def test_a_pyusb_without_those_names_is_told_which_it_lacks() -> None:
    stranger = SimpleNamespace(backend=SimpleNamespace(), _ctx=None)
    with pytest.raises(NamesMissing, match=r"backend\.lib, backend\.ctx, Device\._ctx\.managed_open"):
        inside(stranger)


@pytest.mark.parametrize(("seconds", "offered"), [(8.0, 236), pytest.param(60.0, 1796, marks=pytest.mark.slow)])
def test_every_frame_arrives_under_holds_of_90_ms_twice_a_second(seconds: float, offered: int) -> None:
    b = bench(hold_s=0.090, callback_s=CALLBACK_S)
    b.run(seconds)
    assert len(b.frames) == frames_sent(b) >= offered
    for k, frame in enumerate(b.frames):
        np.testing.assert_array_equal(frame.disparity, PICTURES[k % len(PICTURES)])
    steps = np.diff([frame.time_s for frame in b.frames])
    np.testing.assert_allclose(steps, 0.03336925, atol=1e-6)
    counted = b.sensor.counters()
    assert counted.lost_packets == counted.frames_partial == counted.stream_restarts == 0
    b.sensor.close()


def test_a_ring_of_16_by_16_loses_frames_under_the_same_holds() -> None:
    b = bench(hold_s=0.090, callback_s=CALLBACK_S, options=SensorOptions(ring=RingSize(16, 16)))
    b.run(10.0)
    assert 100 < len(b.frames) < 0.95 * frames_sent(b)
    b.sensor.close()


def test_a_ring_of_16_by_16_loses_nothing_without_holds() -> None:
    b = bench(callback_s=0.0002, options=SensorOptions(ring=RingSize(16, 16)))
    b.run(5.0)
    assert len(b.frames) == frames_sent(b)
    b.sensor.close()


def test_the_ring_loses_what_exceeds_it_and_no_more() -> None:
    short, long = (
        bench(hold_s=0.2, callback_s=CALLBACK_S),
        bench(hold_s=0.2, callback_s=CALLBACK_S, options=SensorOptions(ring=RingSize(32, 64))),
    )
    for b in (short, long):
        b.run(10.0)
        b.sensor.close()
    assert len(short.frames) < 270 and len(long.frames) >= 298


def test_reading_in_a_loop_yields_almost_no_whole_frame() -> None:
    clock = VirtualClock()
    simulation = simulate("none", clock, replayed(PICTURES))
    camera = find_kinects(simulation.load()).first().camera
    claim_camera(camera, "the camera")
    tally = new_tally()
    write_all(CameraCommands(camera, clock, tally), START_DEPTH)
    assembler = Assembler(DEPTH_11, tally)
    buffer = array.array("B", bytes(64 * 1920))
    while clock.now() < 10.0:
        buffer[:] = array.array("B", bytes(len(buffer)))
        camera.read(DEPTH_ENDPOINT, buffer, 1000)
        slots = np.frombuffer(buffer, np.uint8).reshape(64, 1920).copy()
        assembler.take(slots, slot_lengths(slots), np.zeros(64, np.int32))
    assert tally.packets > 50_000, "the control itself does not read"
    assert tally.frames_complete <= 10
    let_go(camera)


def test_a_short_queue_gets_a_small_ring() -> None:
    b = bench("short-queue")
    assert b.run(1.0, until=lambda: len(b.frames) >= 10)
    assert b.sensor.counters().submissions_failed == 1 and in_use(b.simulation.host)["transfers"] == 16
    b.sensor.close()


def opened_camera() -> tuple[Any, Simulation, VirtualClock]:
    """A claimed camera that sends."""
    clock = VirtualClock()
    simulation = simulate("none", clock, replayed(PICTURES))
    camera = find_kinects(simulation.load()).first().camera
    claim_camera(camera, "the camera")
    write_all(CameraCommands(camera, clock, new_tally()), START_DEPTH)
    return camera, simulation, clock


def test_a_transfer_whose_reader_raises_goes_on_listening() -> None:
    camera, simulation, clock = opened_camera()
    tally, calls = new_tally(), []

    def broken(*_: Any) -> None:
        calls.append(clock.now())
        raise RuntimeError("a broken reader")

    ring = IsoRing(camera, DEPTH_ENDPOINT, broken, tally, RingSize(4, 16))
    ring.start()
    while clock.now() < 1.0:
        ring.pump(0.1)
    assert ring.in_flight == 4 and len(calls) > 100
    assert tally.callback_errors == len(calls) and ring.last_error == "RuntimeError: a broken reader"
    ring.stop()
    assert in_use(simulation.host)["transfers"] == 0
    let_go(camera)
    assert misuse() == []


def test_a_stopped_ring_can_be_started_again_and_a_running_one_cannot() -> None:
    camera, simulation, _ = opened_camera()
    ring = IsoRing(camera, DEPTH_ENDPOINT, lambda *_: None, new_tally())
    for _ in range(3):
        ring.start()
        with pytest.raises(RuntimeError, match="already running"):
            ring.start()
        ring.pump(0.1)
        ring.stop()
        ring.stop()
    let_go(camera)
    assert misuse() == [] and in_use(simulation.host)["handles"] == in_use(simulation.host)["transfers"] == 0


def test_a_ring_on_an_unplugged_camera_says_so() -> None:
    camera, simulation, _ = opened_camera()
    simulation.host.unplug(simulation.kinect)
    with pytest.raises(KinectError) as caught:
        IsoRing(camera, DEPTH_ENDPOINT, lambda *_: None, new_tally()).start()
    assert caught.value.fault is Fault.UNPLUGGED
    let_go(camera)
    assert in_use(simulation.host)["transfers"] == 0


@pytest.mark.parametrize("size", [RingSize(0, 64), RingSize(14, 60), RingSize(14, 0)])
def test_a_ring_of_an_impossible_size_is_refused(size: RingSize) -> None:
    camera, _, _ = opened_camera()
    with pytest.raises(ValueError, match="multiple of 8"):
        IsoRing(camera, DEPTH_ENDPOINT, lambda *_: None, new_tally(), size)
    let_go(camera)


def test_where_the_names_have_vanished_threads_read_instead(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(*_: Any) -> None:
        raise NamesMissing("this pyusb lacks everything")

    monkeypatch.setattr(opened_kinect, "IsoRing", type("NoRing", (), {"__init__": missing}))
    simulation = simulate("none", source=replayed(PICTURES))
    sensor = KinectSensor(simulation.load)
    frames = []
    for _ in range(400):
        sensor.step(0.02)
        frames += sensor.poll()
        if len(frames) >= 15:
            break
    assert isinstance(sensor._opened and sensor._opened._readers[0][0], IsoReadThreads)
    assert len(frames) >= 15 and all(any((f.disparity == p).all() for p in PICTURES) for f in frames if not f.has_holes)
    sensor.close()
    assert misuse() == [] and in_use(simulation.host)["handles"] == 0


def test_reading_threads_notice_an_unplugged_device() -> None:
    def read(*_: Any) -> int:
        raise usb.core.USBError("gone", -4, errno.ENODEV)

    endpoint = SimpleNamespace(bEndpointAddress=0x82, wMaxPacketSize=0x0BC0)
    device = SimpleNamespace(get_active_configuration=lambda: [[endpoint]], read=read)
    reader = IsoReadThreads(device, 0x82, lambda *_: None, new_tally(), threads=2, packets=8)
    reader.start()
    reader.stop()
    assert reader.unplugged and reader.in_flight == 0
