"""Long sentences of a sensor in trouble keep to their part of the screen."""

from hypothesis import given
from hypothesis import strategies as st

from game.overlay.line_breaks import lines_within


def test_a_sentence_that_fits_stays_one_line() -> None:
    assert lines_within("Looking for a Kinect.", 30, len) == ["Looking for a Kinect."]


def test_a_long_one_is_broken_between_words() -> None:
    assert lines_within("The Kinect was unplugged: plug it in again.", 16, len) == ["The Kinect was", "unplugged: plug", "it in again."]


def test_nothing_gives_no_line() -> None:
    assert lines_within("", 10, len) == []


@given(st.lists(st.text("abc.", min_size=1, max_size=12), max_size=20), st.integers(1, 40))
def test_no_word_is_lost_and_no_line_is_wider_than_it_must_be(words: list[str], limit: int) -> None:
    lines = lines_within(" ".join(words), limit, len)
    assert " ".join(lines).split() == words
    assert all(len(line) <= limit or " " not in line for line in lines)
