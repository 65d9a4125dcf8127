"""A simulated camera: its registers, its slow and sometimes wayward answers, its two streams."""

import struct
from dataclasses import dataclass, field

import numpy as np

from kinect.device_calibration import TYPICAL, DeviceCalibration
from kinect.usb.command import COMMAND_MAGIC, HEADER, NOT_READY, READ_REGISTER, REPLY_MAGIC, WRITE_REGISTER
from kinect.usb.packet import DEPTH_11, INFRARED_10, RGB_BAYER
from kinect.usb.read_calibration import ALGORITHM_PARAMETERS, FIXED_PARAMETERS
from kinect.usb.simulated_devices import CAMERA_ENDPOINTS, ERROR_PIPE, Endpoint, SimulatedDevice
from kinect.usb.simulated_stream import MICROFRAMES_PER_S, FrameSource, SimulatedStream
from kinect.usb.stream_registers import DEPTH_ENDPOINT, DEPTH_FORMAT, DEPTH_STREAM, VIDEO_ENDPOINT, VIDEO_STREAM

ANSWER_S = 0.002


def _no_frame(_: int) -> None:
    return None


def _noise(octets: int) -> FrameSource:
    return lambda k: np.random.default_rng(k).integers(0, 256, octets, np.uint8)


@dataclass(eq=False)
class SimulatedCamera(SimulatedDevice):
    """faults, all counted down: "stall" and "not ready" answers, "mute" commands, "stale" replies put before the right one."""

    settings: tuple[tuple[Endpoint, ...], ...] = (CAMERA_ENDPOINTS,)
    source: FrameSource = _no_frame
    calibration: DeviceCalibration = TYPICAL
    fixed_bytes: int = 322
    registers: dict[int, int] = field(default_factory=dict)
    streams: dict[int, SimulatedStream] = field(default_factory=dict)
    answers: list[tuple[float, bytes]] = field(default_factory=list)
    ticks: int = 0
    sends: bool = True
    asked: list[int] = field(default_factory=list)

    def reset(self, now: float) -> None:
        """Plugged in: everything off, the clock of ticks at 0."""
        super().reset(now)
        self.registers, self.streams, self.answers = {0x105: 1}, {}, []
        self.ticks = -round(now * 60e6)

    def control(self, out: bool, request: int, value: int, data: bytes, length: int, now: float) -> bytes | int:
        """A command, or a poll for its answer."""
        if request != 0 or self._spend("stall"):
            return ERROR_PIPE
        if not out:
            if not self.answers or self.answers[0][0] > now:
                return b""
            return self.answers.pop(0)[1]
        if len(data) < HEADER.size or data[:2] != COMMAND_MAGIC:
            return ERROR_PIPE
        _, words, code, tag = HEADER.unpack_from(data)
        self.asked.append(code)
        if self._spend("mute"):
            return b""
        if self._spend("stale"):
            self._answer(now, code, (tag - 7) & 0xFFFF, b"\0\0")
        if self._spend("not ready"):
            self._answer(now, code, tag, struct.pack("<H", NOT_READY))
        else:
            self._answer(now, code, tag, self._obey(code, data[HEADER.size : HEADER.size + 2 * words], now))
        return b""

    def _spend(self, fault: str) -> bool:
        left = self.faults.get(fault, 0)
        self.faults[fault] = max(left - 1, 0)
        return left > 0

    def _answer(self, now: float, code: int, tag: int, payload: bytes) -> None:
        self.answers.append((now + ANSWER_S, HEADER.pack(REPLY_MAGIC, len(payload) // 2, code, tag) + payload))

    def _obey(self, code: int, payload: bytes, now: float) -> bytes:
        words = struct.unpack(f"<{len(payload) // 2}H", payload)
        if code == READ_REGISTER and len(words) == 1:
            return struct.pack("<HH", 0, self.registers.get(words[0], 0))
        if code == WRITE_REGISTER and len(words) == 2:
            self._write(words[0], words[1], now)
            return b"\0\0"
        if code == FIXED_PARAMETERS and len(words) == 5:
            c = self.calibration
            floats = (c.baseline_m * 100, 2.3, c.zero_plane_distance_m * 100, c.zero_plane_pixel_size_m * 100)
            return (b"\0\0" + bytes(92) + struct.pack("<4f", *floats)).ljust(self.fixed_bytes, b"\0")
        if code == ALGORITHM_PARAMETERS and words and words[0] == 0:
            return struct.pack("<HH", 0, int(self.calibration.const_shift))
        return struct.pack("<H", 2)

    def _write(self, register: int, value: int, now: float) -> None:
        self.registers[register] = value
        start = int(np.ceil(now * MICROFRAMES_PER_S)) + 16
        ticks = self.ticks + round(now * 60e6)
        if register == DEPTH_STREAM:
            self.streams.pop(DEPTH_ENDPOINT, None)
            if value == 2 and self.registers.get(DEPTH_FORMAT) == 3:
                self.streams[DEPTH_ENDPOINT] = SimulatedStream(DEPTH_11, self.source, start, ticks)
        elif register == VIDEO_STREAM:
            self.streams.pop(VIDEO_ENDPOINT, None)
            if value:
                layout = RGB_BAYER if value == 1 else INFRARED_10
                self.streams[VIDEO_ENDPOINT] = SimulatedStream(layout, _noise(layout.frame_bytes), start, ticks)
