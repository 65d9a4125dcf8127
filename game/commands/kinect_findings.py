"""The doctor's findings: each a subject, a plain sentence, and what to do about it."""

import math
from dataclasses import dataclass
from enum import Enum
from typing import Final

from game.commands.kinect_examination import Examination, Sight
from game.commands.kinect_host import HostFacts, door
from kinect.usb.errors import Fault

FEW_LOST, MANY_LOST = 0.001, 0.01
LITTLE_SEEN, HALF_SEEN = 0.25, 0.5
LOW_M, HIGH_M = 0.6, 1.8
ASKEW_DEG: Final = 4.0
FAR_FLOOR_M: Final = 3.0
OPENED_BUT: Final = (Fault.SILENT, Fault.LOSSY, Fault.UNPLUGGED)


class Mark(Enum):
    """How a finding stands: fine, worth knowing, or to be mended."""

    OK = "ok"
    NOTE = "note"
    WRONG = "WRONG"


@dataclass(frozen=True)
class Finding:
    """subject: a word that docs/kinect.md explains. remedies: lines that say what to do, most likely first."""

    mark: Mark
    subject: str
    sentence: str
    remedies: tuple[str, ...] = ()


def findings(seen: Examination) -> list[Finding]:
    """Everything worth saying, from the cable to the player's feet; what could not be looked at is left out."""
    said = [libusb(seen)]
    if seen.libusb is None:
        return said
    said.append(device(seen))
    if seen.found.kinects:
        said.append(access(seen))
    if seen.found.kinects and seen.fault not in (Fault.PERMISSION, Fault.BUSY, Fault.WRONG_DRIVER, Fault.PROTOCOL, Fault.REFUSED):
        said += [pictures(seen), packets(seen)]
    if seen.sight is not None:
        said += [sight(seen.sight), tilt(seen), floor(seen, seen.sight), feet(seen.sight)]
    return said


def libusb(seen: Examination) -> Finding:
    if seen.libusb is None:
        return Finding(Mark.WRONG, "libusb", seen.sentence)
    return Finding(Mark.OK, "libusb", f"libusb is there: {seen.libusb}.")


def device(seen: Examination) -> Finding:
    if not seen.found.kinects:
        return Finding(Mark.WRONG, "device", seen.sentence, _where_to_look(seen))
    used = seen.used or seen.found.kinects[0]
    parts = [name for name, part in (("motor", used.motor), ("audio", used.audio)) if part is not None]
    beside = f", with its {' and '.join(parts)}" if parts else ""
    more = f" {len(seen.found.kinects)} Kinects are plugged in; this one is used." if len(seen.found.kinects) > 1 else ""
    newer = " A newer Kinect beside it is left alone: it is not supported." if seen.found.newer else ""
    notes = (used.model.limits,) if used.model.limits else ()
    return Finding(Mark.OK, "device", f"{used.model.value} on {used.place}{beside}.{more}{newer}", notes)


def _where_to_look(seen: Examination) -> tuple[str, ...]:
    if seen.fault is Fault.NO_POWER:
        return ("The Kinect takes 12 V from the adapter's wall plug or from its console; a bare USB cable feeds the motor only.",)
    if seen.fault is Fault.NO_DEVICE:
        plugged = "It takes ten seconds to show after plugging in. Some USB 3 ports never see it: try another one, with no hub between."
        driver = "On Windows libusb sees it only after Zadig has given its camera the driver WinUSB or libusbK."
        return (plugged, driver) if seen.host.system == "win32" else (plugged,)
    return ()


def access(seen: Examination) -> Finding:
    host = seen.host
    if seen.fault is Fault.PERMISSION:
        return Finding(Mark.WRONG, "access", seen.sentence, _ask_for_rights(host))
    if seen.fault is Fault.BUSY:
        return Finding(Mark.WRONG, "access", seen.sentence, _let_it_go(host))
    if seen.fault in (Fault.WRONG_DRIVER, Fault.PROTOCOL, Fault.REFUSED):
        return Finding(Mark.WRONG, "access", seen.sentence)
    taken = " The kernel's webcam driver gspca_kinect was taken off it for the while." if host.webcam_driver else ""
    return Finding(Mark.OK, "access", f"It may be opened, and no other program has it.{taken}")


def _ask_for_rights(host: HostFacts) -> tuple[str, ...]:
    if host.system != "linux":
        return ("Close every other program that may use it, and run this one as administrator once.",)
    if host.rule:
        return (
            "The udev rule is in place, so unplug the Kinect and plug it in again.",
            "The rule lends it to whoever sits at this computer: over ssh or in a container it does not count.",
        )
    return (f"Type: sudo {door()} kinect install-rules --yes", "Then unplug the Kinect and plug it in again.")


def _let_it_go(host: HostFacts) -> tuple[str, ...]:
    who = (f"These programs have it open: {', '.join(host.holders)}.",) if host.holders else ()
    driver = ("The webcam driver is loaded. For now: sudo rmmod gspca_kinect",) if host.webcam_driver else ()
    return (*who, *driver, "A game that hung may still hold it: end it, or unplug the Kinect and plug it in again.")


def pictures(seen: Examination) -> Finding:
    c = seen.counters
    loose = f" It left the bus {c.unplugs} time{'s' if c.unplugs > 1 else ''} meanwhile." if c.unplugs else ""
    if not seen.frames:
        hint = () if seen.fault is not None else ("Give it more time: --seconds 20",)
        return Finding(Mark.WRONG, "pictures", seen.sentence if seen.fault else f"No picture came in {seen.seconds:g} s.{loose}", hint)
    rate = (seen.frames - 1) / seen.listened_s if seen.listened_s > 0.5 else 30.0
    came = f"{seen.frames} depth picture{'s' if seen.frames > 1 else ''} came, the first after {seen.first_s or 0.0:.1f} s"
    sentence = f"{came}.{loose}" if c.unplugs else f"{came}, then {rate:.0f} a second."
    if c.unplugs:
        gone = (seen.sentence,) if seen.fault is Fault.UNPLUGGED else ("It is back now.",)
        return Finding(
            Mark.WRONG,
            "pictures",
            sentence,
            (*gone, "If nobody pulled it: a loose plug, a tired adapter, or a USB port with too little current."),
        )
    if rate < 27.0:
        return Finding(Mark.WRONG, "pictures", sentence, ("A Kinect sends 30 a second; the next line says where the others went.",))
    return Finding(Mark.OK, "pictures", sentence)


def packets(seen: Examination) -> Finding:
    c = seen.counters
    told = f"{c.loss:.1%} of {c.packets + c.lost_packets} packets were lost"
    details = f"({c.bad_packets} came with errors, {c.frames_partial} pictures had holes, {c.frames_rejected} were too holey to use)"
    own = _stood_still(seen)
    if c.packets + c.lost_packets == 0:
        return Finding(Mark.WRONG, "packets", "Not one packet came.", ("Try another USB port, straight in the computer.",))
    if c.loss > MANY_LOST:
        port = (
            "Try another USB port, straight in the computer: no hub, no webcam beside it, no virtual machine; USB 2 ports are often better."
        )
        return Finding(Mark.WRONG, "packets", f"{told} {details}.", (port, own))
    if c.loss > FEW_LOST:
        return Finding(Mark.NOTE, "packets", f"{told} {details}: the game copes with that.", (own,))
    return Finding(Mark.OK, "packets", f"{told}.")


def _stood_still(seen: Examination) -> str:
    """Whether losses may be this program's own, which reads too late where it is held up."""
    stood, bridged = f"This program stood still for {1e3 * seen.stall_s:.0f} ms at the longest", f"{1e3 * seen.queue_s:.0f} ms"
    if seen.stall_s > seen.queue_s:
        return f"{stood}, longer than the {bridged} that are queued, so losses may be its own: close other programs and look again."
    return f"{stood}, and {bridged} are queued, so the losses are not its own."


def sight(seen: Sight) -> Finding:
    sentence = f"{seen.share:.0%} of the picture holds distances"
    if seen.share < LITTLE_SEEN:
        sun = "sunlight drowns the Kinect's own pattern: draw the curtains, or turn it away from the window."
        near = "something is nearer than 0.5 m, where it is blind: clear the space in front of it, take its foil off."
        likely, else_ = (near, sun) if seen.share < 0.01 else (sun, near)
        return Finding(Mark.WRONG, "sight", f"{sentence}: far too little.", (f"Most likely {likely}", f"Or {else_}"))
    if seen.share < HALF_SEEN:
        why = "Sun, black or shiny cloth, glass, and what is nearer than 0.5 m or farther than 8 m give none."
        return Finding(Mark.NOTE, "sight", f"{sentence}: rather little.", (why,))
    return Finding(Mark.OK, "sight", f"{sentence}.")


def tilt(seen: Examination) -> Finding:
    turned = (seen.turned,) if seen.turned else ()
    where = seen.sight.floor if seen.sight is not None else None
    if seen.level is not None:
        pitch, roll, by = math.degrees(seen.level.pitch_rad), math.degrees(seen.level.roll_rad), "its accelerometer"
    elif where is not None:
        pitch, roll, by = math.degrees(math.atan2(where.c, where.b)), math.degrees(math.atan2(where.a, where.b)), "the floor"
    else:
        return Finding(Mark.NOTE, "tilt", "How it is tilted cannot be told: it has no accelerometer for us, and no floor is seen.", turned)
    looks = "level" if abs(pitch) < 0.5 else f"{abs(pitch):.0f} degrees {'up' if pitch > 0 else 'down'}"
    sentence = f"By {by} it looks {looks}"
    if abs(roll) > ASKEW_DEG:
        return Finding(
            Mark.NOTE, "tilt", f"{sentence} and leans {abs(roll):.0f} degrees to its side.", (*turned, "Put it on something level.")
        )
    return Finding(Mark.OK, "tilt", f"{sentence}.", turned)


def floor(seen: Examination, saw: Sight) -> Finding:
    if saw.floor is None:
        why = f"{saw.floor_why[:1].upper()}{saw.floor_why[1:]}."
        if saw.share < LITTLE_SEEN:
            return Finding(Mark.WRONG, "floor", why, ("First see to it that it sees anything at all.",))
        up = seen.level is not None and math.degrees(seen.level.pitch_rad) > 3.0
        looks_up = "It looks up: tilt it down until the floor is in the picture."
        return Finding(
            Mark.WRONG, "floor", why, (looks_up if up else "Tilt it down a little, and clear the floor before it.", _how_to_tilt(seen))
        )
    height = saw.floor.d
    sentence = f"The Kinect stands {height:.2f} m over the floor"
    if not LOW_M <= height <= HIGH_M:
        return Finding(
            Mark.NOTE, "floor", f"{sentence}.", (f"Put it {LOW_M:g} to {HIGH_M:g} m high, best just below or above the screen.",)
        )
    return Finding(Mark.OK, "floor", f"{sentence}.")


def _how_to_tilt(seen: Examination) -> str:
    """By its motor where that answers us: forcing the head by hand wears the gear."""
    if seen.used is not None and seen.used.motor is not None:
        return "Its motor does that: kinect doctor --tilt -5 (degrees above the horizon, here 5 below it)."
    return "Its motor does not answer here: turn the head slowly by hand, or put something under its foot."


def feet(saw: Sight) -> Finding:
    if saw.floor is None:
        return Finding(Mark.NOTE, "feet", "Whether your feet are in the picture cannot be told without a floor.")
    begins = f"The floor is in the picture from {saw.floor_from_m:.1f} m on"
    if saw.floor_from_m > 8.0:
        begins = "The floor right before it is not in the picture"
    if saw.cut_off is not None:
        cut = f"Something {saw.cut_off.away_m:.1f} m away is cut off {saw.cut_off.above_floor_m:.1f} m above the floor."
        step = f"If that is you, your feet are out of view. {begins}: step back that far, or tilt the Kinect down."
        return Finding(Mark.WRONG, "feet", cut, (step,))
    if saw.floor_from_m > FAR_FLOOR_M:
        return Finding(Mark.NOTE, "feet", f"{begins}: nearer than that your feet cannot be seen.", ("Tilt the Kinect down a little.",))
    return Finding(Mark.OK, "feet", f"{begins}: stand at least there. Nobody's feet are cut off now.")
