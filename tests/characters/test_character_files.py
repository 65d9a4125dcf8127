"""A player's own character file gives a character, or one sentence that names the file, the field and what would be valid."""

import math
from pathlib import Path

import numpy as np
import pytest
import tomli_w
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from game.assets import asset
from game.characters.body_plan import BUILT_IN, BodyPlanError, load_body_plan
from game.characters.skeleton import PARTS

FUZZ = settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])


def written(folder: Path, text: str, name: str = "mine.toml") -> str:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return str(path)


def complaint(name: str) -> str:
    """The one sentence with which a character is refused."""
    with pytest.raises(BodyPlanError) as fault:
        load_body_plan(name)
    sentence = str(fault.value)
    assert "\n" not in sentence and sentence.endswith(".") and len(sentence) < 600
    return sentence


def test_a_copy_of_a_built_in_character_is_that_character(tmp_path):
    own = load_body_plan(written(tmp_path, asset("characters/original.toml").read_text(encoding="utf-8")))
    original = load_body_plan("original")
    assert own.name == "mine"
    for field in ("size", "mass", "joint", "centre"):
        np.testing.assert_array_equal(getattr(own, field), getattr(original, field))


def test_what_a_file_does_not_say_is_as_in_the_character_it_is_based_on(tmp_path):
    own = load_body_plan(written(tmp_path, 'based_on = "human"\nabout = "big head"\n[part.head]\nmass_kg = 9\n'))
    human = load_body_plan("human")
    changed = own.mass != human.mass
    assert [part for part, is_changed in zip(PARTS, changed) if is_changed] == ["head"]
    assert own.about == "big head"
    np.testing.assert_array_equal(own.size, human.size)


def test_a_limb_without_its_side_is_given_for_the_left_and_mirrored_to_the_right(tmp_path):
    own = load_body_plan(written(tmp_path, 'based_on = "original"\n[part.hand]\ncentre_m = [0.01, 0.25, 0.82]\n'))
    np.testing.assert_array_equal(own.centre[PARTS.index("hand_left")], [0.01, 0.25, 0.82])
    np.testing.assert_array_equal(own.centre[PARTS.index("hand_right")], [0.01, -0.25, 0.82])


def test_a_limb_with_its_side_is_taken_at_its_word(tmp_path):
    own = load_body_plan(written(tmp_path, 'based_on = "original"\n[part.hand_right]\ncentre_m = [0.01, -0.25, 0.82]\n'))
    original = load_body_plan("original")
    np.testing.assert_array_equal(own.centre[PARTS.index("hand_right")], [0.01, -0.25, 0.82])
    np.testing.assert_array_equal(own.centre[PARTS.index("hand_left")], original.centre[PARTS.index("hand_left")])


def test_a_file_is_based_on_a_file_beside_it_wherever_the_game_was_started(tmp_path, monkeypatch):
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    written(tmp_path, 'based_on = "original"\n[part.foot]\nmass_kg = 3.0\n', "parent.toml")
    own = load_body_plan(written(tmp_path, 'based_on = "parent.toml"\n[part.head]\nmass_kg = 7.0\n'))
    assert own.mass[PARTS.index("foot_right")] == 3.0 and own.mass[PARTS.index("head")] == 7.0


@pytest.mark.parametrize("based_on", ['"mine.toml"', '"./mine.toml"', '"other.toml"'])
def test_a_file_cannot_be_based_on_itself(tmp_path, based_on):
    written(tmp_path, 'based_on = "mine.toml"', "other.toml")
    sentence = complaint(written(tmp_path, f"based_on = {based_on}"))
    assert "based_on" in sentence and "valid: original, human" in sentence


@pytest.mark.parametrize("name", ["gorilla", "", "nowhere/gorilla.toml", "original.json", "x" * 5000 + ".toml"])
def test_an_unknown_character_is_answered_with_those_that_exist(name):
    sentence = complaint(name)
    assert all(known in sentence for known in BUILT_IN)


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("[part.pelvis]\nmass_kg = 3", "part.pelvis.size_m is missing"),
        ('based_on = "original"\n[part.pelvis]\nmass_kg = -3', "part.pelvis.mass_kg must be a number from"),
        ('based_on = "original"\n[part.pelvis]\nmass_kg = 0', "part.pelvis.mass_kg must be a number from"),
        ('based_on = "original"\n[part.pelvis]\nmass_kg = "10"', "part.pelvis.mass_kg must be a number from"),
        ('based_on = "original"\n[part.pelvis]\nmass_kg = true', "part.pelvis.mass_kg must be a number from"),
        ('based_on = "original"\n[part.pelvis]\nmass_kg = nan', "part.pelvis.mass_kg must be a number from"),
        ('based_on = "original"\n[part.pelvis]\nmass_kg = 1e300', "part.pelvis.mass_kg must be a number from"),
        ('based_on = "original"\n[part.pelvis]\nmass_kg = 0x' + "f" * 6000, "part.pelvis.mass_kg must be a number from"),
        ('based_on = "original"\n[part.pelvis]\nmass_kg = 1979-05-27', "part.pelvis.mass_kg must be a number from"),
        ('based_on = "original"\n[part.foot]\nsize_m = [0.3, 0.15]', "part.foot.size_m must be 3 numbers from"),
        ('based_on = "original"\n[part.foot]\nsize_m = [[0.3, 0.15, 0.1]]', "part.foot.size_m must be 3 numbers from"),
        ('based_on = "original"\n[part.foot]\njoint_m = [inf, 0.0, 0.0]', "part.foot.joint_m must be 3 numbers from"),
        ('based_on = "original"\n[part.foot]\ncolour = 3', "part.foot has no field 'colour'"),
        ('based_on = "original"\n[part.tail]\nmass_kg = 3', "no part 'tail'"),
        ('based_on = "original"\n[part]\npelvis = 3', "part.pelvis must be a table"),
        ('based_on = "original"\npart = 3', "part must be a table"),
        ('based_on = "original"\n[parts.pelvis]\nmass_kg = 3', "no entry 'parts'"),
        ("based_on = 3", "based_on = 3"),
        ('based_on = ["original"]', "based_on = ['original']"),
        ('based_on = "gorilla"', "based_on = 'gorilla'"),
        ('based_on = "original"\n[part.foot]\njoint_m = [0.0, 0.095, 0.6]', "part.foot_left.joint_m must lie at least"),
        ('based_on = "original"\n[part.foot]\ncentre_m = [0.0, 0.095, 0.2]', "size_m and centre_m must put the lowest box on the floor"),
        ("[part", "no valid TOML"),
        ("x = " + "9" * 5000, "no valid TOML"),
        ("x = " + "[" * 5000, "no valid TOML"),
    ],
)
def test_a_spoilt_file_is_refused_with_its_name_and_the_field(tmp_path, text, named):
    sentence = complaint(written(tmp_path, text))
    assert "mine.toml" in sentence and named in sentence


def test_a_file_of_other_bytes_than_text_is_refused(tmp_path):
    (tmp_path / "mine.toml").write_bytes(b'about = "\xff\xfe"')
    assert "mine.toml" in complaint(str(tmp_path / "mine.toml"))


VALUE = st.recursive(
    st.none() | st.booleans() | st.integers(-(10**30), 10**30) | st.floats() | st.text(max_size=8) | st.floats(0.02, 2.0),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.sampled_from(["size_m", "x"]), inner, max_size=2),
    max_leaves=6,
).filter(lambda value: value is not None)
FIELDS = st.dictionaries(st.sampled_from(["size_m", "mass_kg", "joint_m", "centre_m", "density"]), VALUE, max_size=3)
PART_NAME = st.sampled_from([*PARTS, "arm", "hand", "foot", "", "lower_leg"])
DOCUMENT = st.fixed_dictionaries(
    {},
    optional={
        "based_on": st.one_of(st.sampled_from(BUILT_IN), st.just("mine.toml"), st.text(max_size=5), VALUE),
        "about": VALUE,
        "part": st.one_of(st.dictionaries(PART_NAME, st.one_of(FIELDS, VALUE), max_size=3), VALUE),
        "shape": VALUE,
    },
)


def has_no_none(value: object) -> bool:
    if isinstance(value, dict):
        return all(map(has_no_none, value.values()))
    return all(map(has_no_none, value)) if isinstance(value, list) else value is not None


def a_body_or_one_sentence(path: Path) -> None:
    try:
        plan = load_body_plan(str(path))
    except BodyPlanError as fault:
        sentence = str(fault)
        assert "mine.toml" in sentence and "\n" not in sentence and sentence.endswith(".")
        return
    assert np.all(plan.size > 0.0) and np.all(plan.mass > 0.0)
    assert all(np.all(np.isfinite(rows)) for rows in (plan.size, plan.mass, plan.joint, plan.centre))
    assert 0.0 < plan.idle_com_height < math.inf


@FUZZ
@given(document=DOCUMENT.filter(has_no_none))
def test_whatever_a_file_says_it_gives_a_body_or_one_sentence(tmp_path, document):
    (tmp_path / "mine.toml").write_text(tomli_w.dumps(document), encoding="utf-8")
    a_body_or_one_sentence(tmp_path / "mine.toml")


ORIGINAL = asset("characters/original.toml").read_bytes()


@FUZZ
@given(data=st.data())
def test_a_file_with_some_bytes_changed_gives_a_body_or_one_sentence(tmp_path, data):
    spoilt = bytearray(ORIGINAL)
    for place in data.draw(st.lists(st.integers(0, len(ORIGINAL) - 1), max_size=6)):
        spoilt[place] = data.draw(st.integers(0, 255))
    (tmp_path / "mine.toml").write_bytes(bytes(spoilt))
    a_body_or_one_sentence(tmp_path / "mine.toml")
