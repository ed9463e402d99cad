import json
import keyword
import subprocess

import pytest
from conftest import PROGRAM, refused

import espalier


def methods():
    return json.loads(subprocess.check_output([PROGRAM, "methods", "--json"]))


def attribute(name):
    return name + "_" * keyword.iskeyword(name)


def test_every_option_of_the_program_is_documented():
    count = 0
    for method in methods():
        step = type(getattr(espalier.Options(), method["step"]))
        assert method["help"] in step.__doc__
        for option in method["options"]:
            document = getattr(step, attribute(option["name"])).__doc__
            assert option["help"] in document
            assert f"default {option['rule']}, " in document
            count += 1
    assert count > 100


def test_defaults_are_those_of_the_program():
    for method in methods():
        options = espalier.Options()
        step = getattr(options, method["step"])
        if method["is_default"]:
            assert step.method == method["method"]
        step.method = method["method"]
        for option in method["options"]:
            value = getattr(step, attribute(option["name"]))
            if isinstance(value, bool):
                value = "yes" if value else "no"
            assert option["rule"] == (value if isinstance(value, str) else f"{value:g}")


def test_options_are_set_and_reset():
    options = espalier.Options(unit="mm")
    rule = options.contract.radius
    options.contract.radius = 12.5
    assert options.contract.radius == 12.5
    options.contract.radius = "0.02 heights"
    assert options.contract.radius == "0.02 plant heights"
    options.contract.radius = "3 cm"
    assert options.contract.radius == 30
    del options.contract.radius
    assert options.contract.radius == rule
    default = options.contract.method
    options.contract.method = "adaptive_geodesic"
    options.contract.circles = False
    assert options.contract.circles is False
    assert json.loads(repr(options)) == {"contract": {"method": "adaptive_geodesic", "circles": False}}
    del options.contract.method
    assert options.contract.method == default


def test_another_method_begins_with_its_defaults():
    options = espalier.Options("thesis")
    assert hasattr(options.contract, "curve")
    options.contract.method = "geodesic_centroid"
    assert repr(options.contract.radius) == repr(espalier.Options().contract.radius)
    options.contract.radius = 2
    options.contract.method = "geodesic_centroid"
    assert options.contract.radius == 2, "it is the same method"
    options.contract.method = "adaptive_geodesic"
    options.contract.circles = False
    del options.contract.method
    assert json.loads(repr(options)).get("contract") is None


def test_options_that_are_words_of_python_end_in_an_underscore():
    options = espalier.Options()
    options.crop.method = "slab"
    options.crop.from_ = 0.5
    assert json.loads(repr(options)) == {"crop": {"method": "slab", "from": 0.5}}
    assert not hasattr(options.crop, "from")


def test_presets_are_those_of_the_program(tmp_path):
    assert espalier.Options("thesis").contract.method == "adaptive_geodesic"
    file = tmp_path / "mine.json"
    file.write_text(repr(espalier.Options("thesis")))
    for path in (str(file), file):
        assert repr(espalier.Options(path)) == repr(espalier.Options("thesis"))


@pytest.mark.parametrize(
    "setting, attempt",
    [
        ("contract.radius=wide", lambda options: setattr(options.contract, "radius", "wide")),
        ("contract.radius=3mm", lambda options: setattr(options.contract, "radius", "3mm")),
        ("contract.method=best", lambda options: setattr(options.contract, "method", "best")),
        ("contract.radus=3", lambda options: setattr(options.contract, "radus", 3)),
        ("contract.radus=3", lambda options: options.contract.radus),
        ("contrct.radius=3", lambda options: setattr(options, "contrct", 3)),
        ("contrct.radius=3", lambda options: options.contrct.radius),
    ],
)
def test_errors_are_the_lines_of_the_program(plant, tmp_path, setting, attempt):
    line = refused("reconstruct", plant.file, "-o", tmp_path / "a.mtg", "--set", setting)
    with pytest.raises(espalier.Error) as refusal:
        attempt(espalier.Options())
    assert str(refusal.value) == line


def test_an_unknown_preset_is_the_line_of_the_program(plant, tmp_path):
    line = refused("reconstruct", plant.file, "-o", tmp_path / "a.mtg", "--preset", "none_such")
    with pytest.raises(espalier.Error) as refusal:
        espalier.Options("none_such")
    assert str(refusal.value) == line


def test_unknown_names_are_none_to_python_too():
    options = espalier.Options()
    assert not hasattr(options, "contrct")
    assert not hasattr(options.contract, "radus")
    assert hasattr(options.contract, "radius")


def test_words_of_other_choices_are_named():
    with pytest.raises(espalier.Error, match="up is 'w': choose one of x, y, z"):
        espalier.Options(up="w")
    with pytest.raises(espalier.Error, match="unit is 'ft': choose one of mm, cm, m"):
        espalier.Options(unit="ft")
