"""Decisions, scores and simulated plants against those of the program."""

import json

import pytest
from conftest import run

import espalier


def test_decisions_are_those_of_the_program(plant, found, tmp_path):
    run("reconstruct", plant.file, "-o", tmp_path / "a.mtg", "--json", tmp_path / "a.json")
    known = json.loads((tmp_path / "a.json").read_text())
    decisions = espalier.decisions(found)
    assert len(decisions.ends) == known["ends"]["asked"] > 0
    assert sum(not end.stays for end in decisions.ends) == known["ends"]["removed"]
    assert len(decisions.gaps) == known["gaps"]["asked"]
    assert decisions.expected_right == known["in_doubt"]["expected_right"]
    doubts = known["in_doubt"]["doubts"]
    assert len(decisions.doubts) == len(doubts) > 0
    for doubt, expected in zip(decisions.doubts, doubts):
        assert doubt.kind == expected["kind"]
        assert (doubt.node, doubt.nodes) == (expected["node"], expected["nodes"])
        assert found.skeleton.positions[doubt.node].tolist() == expected["place"]
        assert (doubt.length, doubt.gain, doubt.present) == (
            expected["length"], expected["gain"], expected["present"])
        assert [one.probability for one in doubt.alternatives] == [
            one["probability"] for one in expected["alternatives"]]
        for one, other in zip(doubt.alternatives, expected["alternatives"]):
            assert one.kind == other["kind"]
            assert one.onto == other.get("onto")
            if one.onto is not None:
                assert found.skeleton.positions[one.onto].tolist() == other["onto_place"]
            assert (one.branch is not None) == (one.kind == "add")
            assert (None if one.branch is None else one.branch.tolist()) == other.get("branch")
    read = espalier.Skeleton.read(tmp_path / "a.mtg")
    assert read.positions.tolist() == found.skeleton.positions.tolist(), "rows are those of the file"


def test_ends_and_gaps_have_places(found):
    decisions = espalier.decisions(found)
    for end in decisions.ends:
        assert end.path.shape[1] == 3 and 0 <= end.probability <= 1
    for gap in decisions.gaps:
        link = gap.alternatives[gap.chosen]
        assert link.start.shape == link.end.shape == (3,)


def test_scores_are_those_of_the_program(plant, found, tmp_path):
    found.skeleton.write(tmp_path / "found.mtg")
    plant.truth.write(tmp_path / "truth.mtg")
    for flags, options in (
        ([], {}),
        (["--no-register", "--distance", "0.05"], {"register": False, "distance": 0.05}),
        (["--no-rotate", "--unit", "m", "--up", "y"], {"rotate": False, "unit": "m", "up": "y"}),
    ):
        run("evaluate", tmp_path / "found.mtg", tmp_path / "truth.mtg", *flags,
            "--json", tmp_path / "scores.json")
        known = json.loads((tmp_path / "scores.json").read_text())
        result, truth = (  # of the files, which have classes
            espalier.Skeleton.read(tmp_path / name) for name in ("found.mtg", "truth.mtg"))
        evaluation = espalier.evaluate(result, truth, **options)
        assert evaluation.scores == known["scores"]
        for key, numbers in evaluation.numbers.items():
            if key == "edit_distance":
                known[key] = {name: known[key][name] for name in numbers}
            if key != "warnings":  # the program warns of places, too
                assert numbers == known[key], key


def test_every_score_is_documented(plant):
    scores = espalier.evaluate(plant.truth, plant.truth).scores
    assert scores["f"] == 1
    for key in scores:
        assert f"\n{key}: " in espalier.Evaluation.scores.__doc__


def test_what_cannot_be_compared_is_refused(plant):
    dot = espalier.Skeleton([[0, 0, 0]], [-1])
    with pytest.raises(espalier.Error, match="the reference"):
        espalier.evaluate(plant.truth, dot)
    for distance in (-1, float("nan"), float("inf")):
        with pytest.raises(espalier.Error, match="distance is .*: give a number above 0"):
            espalier.evaluate(plant.truth, plant.truth, distance=distance)


def test_simulated_plants_are_those_of_the_program(tmp_path):
    run("simulate", "-o", tmp_path / "bean", "--seed", 4, "--architecture", "herb", "--points", 3000,
        "--segments", 20, "--foliage", 1)
    scan, truth = espalier.simulate(
        seed=4, architecture="herb", points=3000, segments=20, foliage=1)
    assert truth.mtg() == (tmp_path / "bean.mtg").read_text()
    scan.write(tmp_path / "again.ply")
    assert (tmp_path / "again.ply").read_bytes() == (tmp_path / "bean.ply").read_bytes()
    with pytest.raises(espalier.Error, match="architecture is 'palm'"):
        espalier.simulate(architecture="palm")
