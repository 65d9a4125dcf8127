"""Counts of everything that happens on the wire: on a user's machine they are the whole diagnosis."""

from dataclasses import dataclass
from types import SimpleNamespace


@dataclass(frozen=True)
class Counters:
    """A snapshot. All are counts since the sensor was made."""

    packets: int = 0  # with data and a sound header
    empty_packets: int = 0  # slots in which the device had nothing to say
    bad_packets: int = 0  # with an error status, without a header, or of a wrong length
    lost_packets: int = 0  # seen as gaps in the sequence numbers; of more than 255 in a row only the rest is seen
    repeated_packets: int = 0
    resyncs: int = 0  # times the place in the frame was lost
    frames_complete: int = 0
    frames_partial: int = 0  # handed on with holes of no data
    frames_abandoned: int = 0  # given up when the place in the frame was lost
    frames_rejected: int = 0  # too many holes to be of use
    frames_overrun: int = 0  # whole, but nobody fetched them in time
    transfers_completed: int = 0
    transfers_failed: int = 0
    submissions_failed: int = 0
    callback_errors: int = 0
    transfers_undrained: int = 0  # never came back from libusb; their memory is kept for ever, since libusb may still write to it
    commands: int = 0
    commands_not_ready: int = 0
    commands_repeated: int = 0
    replies_stale: int = 0
    stream_starts: int = 0
    stream_restarts: int = 0  # by the watchdog
    reopens: int = 0  # by the watchdog
    opens_failed: int = 0
    unplugs: int = 0

    @property
    def loss(self) -> float:
        """Share of the packets that were lost, 0..1."""
        offered = self.packets + self.lost_packets
        return self.lost_packets / offered if offered else 0.0


def new_tally() -> SimpleNamespace:
    """All the counts at 0, to be counted up by the one thread that pumps; a name that `Counters` lacks raises at once."""
    return SimpleNamespace(**vars(Counters()))


def snapshot(tally: SimpleNamespace) -> Counters:
    """What the tally holds now."""
    return Counters(**vars(tally))
