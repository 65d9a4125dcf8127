"""One word opens an input; a word that opens none is answered with those that do."""

import pytest

from game.inputs.attached import STEERS, greeting
from game.inputs.open_input import INPUTS, InputError, open_input
from game.inputs.puppet import Puppet, puppet_of
from game.inputs.sensor_noise import SensorNoise
from kinect.clip import ClipSource, write_clip
from kinect.source import BodySource
from kinect.usb.simulated_clock import VirtualClock
from kinect.usb.simulated_host import SimulatedHost
from kinect.usb.simulated_kinect import SimulatedKinect
from kinect.usb.simulated_libusb import simulated_backend
from kinect.usb.simulated_room import Room
from tests.depth.depth_sessions import session, write_fakenect
from tests.kinect.recordings import moving_clip


@pytest.fixture
def specs(tmp_path) -> dict[str, str]:
    write_clip(tmp_path / "sway.npz", moving_clip())
    write_fakenect(tmp_path / "depth", session(32, typical=True))
    return {
        "clip": f"clip:{tmp_path / 'sway.npz'}",
        "performer": "performer:waving",
        "puppet": "puppet",
        "script": "script",
        "auto": "auto",
        "kinect": "kinect",
        "kinect-replay": f"kinect-replay:{tmp_path / 'depth'}",
        "kinect-wire": f"kinect-wire:{tmp_path / 'depth'}",
    }


def test_every_input_meets_the_contract_of_a_source(specs):
    assert set(specs) == set(INPUTS)
    for spec in specs.values():
        source: BodySource = open_input(spec)
        first = source.poll(0.0)
        later = source.poll(1.0)
        assert [frame.time_s for frame in first] == [0.0]
        assert len(later) >= 28 and all(0.0 < frame.time_s <= 1.0 for frame in later)
        assert source.poll(1.0) == []
        assert source.status.endswith(".")
        assert source.length_s is None or source.length_s > 1.0
        source.close()
        source.close()


@pytest.mark.parametrize("spec", ["", "kinect:0", "clip", "clip:", "performer", "puppet:left", "auto:1", "Puppet"])
def test_a_word_that_opens_nothing_is_answered_with_the_valid_ones(spec):
    with pytest.raises(InputError) as caught:
        open_input(spec)
    assert repr(spec) in str(caught.value)
    assert "clip:PATH, performer:NAME, puppet, script, auto" in str(caught.value)


def test_a_recording_or_performer_that_is_not_there_is_named():
    with pytest.raises(InputError, match=r"nowhere\.npz"):
        open_input("clip:nowhere.npz")
    with pytest.raises(InputError, match="waving"):
        open_input("performer:juggling")


def test_a_path_may_hold_a_colon(tmp_path):
    write_clip(tmp_path / "a:b.npz", moving_clip())
    assert isinstance(open_input(f"clip:{tmp_path / 'a:b.npz'}"), ClipSource)


def test_the_sensor_model_lies_over_synthetic_inputs_only(specs):
    for kind, spec in specs.items():
        source = open_input(spec, noise=0.5, latency_s=0.1, outliers=0.3, seed=4)
        if kind in ("clip", "kinect", "kinect-replay", "kinect-wire"):
            assert not isinstance(source, SensorNoise), "a real recording has its own noise"
        else:
            assert isinstance(source, SensorNoise)
            assert (source.scale, source.latency_s, source.outliers) == (0.5, 0.1, 0.3)


def test_the_puppet_inside_can_be_steered_and_others_cannot(specs):
    assert isinstance(puppet_of(open_input("puppet")), Puppet)
    assert isinstance(puppet_of(open_input("auto")), Puppet)
    assert puppet_of(open_input("script")) is None
    assert puppet_of(open_input(specs["clip"])) is None


def test_auto_says_why_nobody_is_tracked():
    assert "Kinect" in open_input("auto").status and STEERS in open_input("auto").status


def test_auto_says_what_is_attached_and_stays_on_the_puppet():
    host = SimulatedHost(VirtualClock())
    backend = simulated_backend(host)
    assert greeting(lambda: backend) == f"No Kinect is attached, so {STEERS}"
    host.plug(SimulatedKinect(Room().source()))
    assert "not tracked from depth yet" in greeting(lambda: backend) and "--input kinect" in greeting(lambda: backend)


def test_auto_steers_on_where_the_bus_cannot_be_looked_at():
    def broken():
        raise OSError("no bus here")

    assert STEERS in greeting(broken)
