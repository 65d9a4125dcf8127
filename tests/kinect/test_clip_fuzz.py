"""Whatever bytes and arrays a file holds, reading it gives a valid clip or one sentence."""

import io
import warnings
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from kinect.clip import Clip, ClipError, ClipSource, read_clip, write_clip
from tests.kinect.recordings import moving_clip, raw_fields

FUZZ = settings(max_examples=80, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.function_scoped_fixture])


def clip_or_one_sentence(path: Path) -> Clip | None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            clip = read_clip(path)
        except ClipError as fault:
            sentence = str(fault)
            assert path.name in sentence and "valid:" in sentence and "\n" not in sentence
            return None
        frames = ClipSource(clip).poll(1e9)
    assert len(frames) == len(clip.t) >= 1
    assert clip.positions.shape == (len(clip.t), 20, 3) and clip.confidence.shape == (len(clip.t), 20)
    assert clip.t[0] == 0.0 and np.all(np.diff(clip.t) > 0.0) and np.all(np.isfinite(clip.t))
    assert np.all((clip.confidence >= 0.0) & (clip.confidence <= 1.0))
    lost = np.isnan(clip.positions).any(axis=2)
    assert np.all(clip.confidence[lost] == 0.0) and np.all(np.isfinite(clip.positions[~lost]))
    floor = frames[0].floor
    assert floor is None or (np.isfinite(floor.d) and np.linalg.norm(floor[:3]) == pytest.approx(1.0))
    return clip


def archive(fields: dict[str, np.ndarray]) -> bytes:
    buffer = io.BytesIO()
    np.savez(buffer, **fields)  # pyright: ignore[reportArgumentType]
    return buffer.getvalue()


SOUND = archive(raw_fields(moving_clip(6)))
ANY_ARRAY = hnp.arrays(
    st.one_of(hnp.floating_dtypes(), hnp.integer_dtypes(), hnp.boolean_dtypes(), hnp.complex_number_dtypes(), hnp.unicode_string_dtypes()),
    hnp.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=5),
)


@FUZZ
@given(data=st.data())
def test_corrupt_bytes_in_an_archive(tmp_path, data):
    spoilt = bytearray(SOUND)
    for place in data.draw(st.lists(st.integers(0, len(SOUND) - 1), max_size=8)):
        spoilt[place] = data.draw(st.integers(0, 255))
    path = tmp_path / "fuzz.npz"
    path.write_bytes(bytes(spoilt[: data.draw(st.one_of(st.just(len(SOUND)), st.integers(0, len(SOUND))))]))
    clip_or_one_sentence(path)


@FUZZ
@given(
    name=st.sampled_from(["positions", "confidence", "t", "fps", "floor", "floor_est", "joint_names", "motion", "extra"]), array=ANY_ARRAY
)
def test_any_array_in_any_field(tmp_path, name, array):
    path = tmp_path / "fuzz.npz"
    path.write_bytes(archive(raw_fields(moving_clip(6)) | {name: array}))
    clip_or_one_sentence(path)


@FUZZ
@given(
    positions=hnp.arrays(np.float32, (4, 20, 3), elements=st.floats(width=32), fill=st.floats(-3.0, 3.0, width=32)),
    t=hnp.arrays(np.float64, 4, elements=st.floats()),
    confidence=hnp.arrays(np.float32, (4, 20), elements=st.floats(width=32), fill=st.sampled_from([0.0, 0.5, 1.0])),
    floor=hnp.arrays(np.float32, 4, elements=st.floats(width=32)),
)
def test_any_numbers_in_the_right_shapes(tmp_path, positions, t, confidence, floor):
    path = tmp_path / "fuzz.npz"
    times = np.arange(4) / 30.0
    path.write_bytes(archive({"positions": positions, "t": np.where(np.isnan(t), times, t), "confidence": np.nan_to_num(confidence)}))
    clip_or_one_sentence(path)
    path.write_bytes(archive({"positions": positions, "t": times, "floor": floor}))
    clip = clip_or_one_sentence(path)
    if clip is not None:
        write_clip(tmp_path / "again.csv", clip)
        again = clip_or_one_sentence(tmp_path / "again.csv")
        assert again is not None, "what could be read can be written and read again"


@FUZZ
@given(
    text=st.lists(
        st.lists(st.one_of(st.floats().map(repr), st.sampled_from(["", "nan", "inf", "x", "#"])), min_size=78, max_size=82).map(",".join),
        max_size=3,
    ),
    tail=st.text(max_size=20),
)
def test_any_text(tmp_path, text, tail):
    path = tmp_path / "fuzz.csv"
    path.write_text("\n".join([*text, tail]), encoding="utf-8", errors="replace")
    clip_or_one_sentence(path)
