import numpy as np
import pytest

import espalier


def fork():
    return espalier.Skeleton(
        positions=[[0, 0, 0], [0, 0, 1], [0, 0, 2], [0, 1, 1.5]],
        parents=[-1, 0, 1, 1],
        radii=[0.3, 0.2, 0, 0.1],
        edges=["<", "<", "<", "+"],
    )


def test_arrays_come_back():
    plant = fork()
    assert len(plant) == 4
    assert plant.positions.tolist() == [[0, 0, 0], [0, 0, 1], [0, 0, 2], [0, 1, 1.5]]
    assert plant.parents.tolist() == [-1, 0, 1, 1]
    assert plant.radii.tolist() == [0.3, 0.2, 0, 0.1]
    assert plant.edges.tolist() == ["<", "<", "<", "+"]
    assert plant.ids.tolist() == [0, 1, 2, 3]


def test_a_skeleton_is_made_again_of_its_arrays(found):
    plant = found.skeleton
    again = espalier.Skeleton(plant.positions, plant.parents, plant.radii, plant.edges)
    assert np.array_equal(again.positions, plant.positions)
    assert np.array_equal(again.parents, plant.parents)
    assert (plant.parents < np.arange(len(plant))).all()


def test_arrays_are_views_that_can_only_be_read(found):
    for name in ("positions", "radii", "parents", "edges", "ids"):
        array = getattr(found.skeleton, name)
        assert np.shares_memory(array, getattr(found.skeleton, name)), name
        assert not array.flags.owndata and not array.flags.writeable, name


def test_without_edges_the_first_child_goes_on():
    plant = espalier.Skeleton(np.eye(4, 3), [-1, 0, 0, 1])
    assert plant.edges.tolist() == ["<", "<", "+", "<"]


def test_parents_may_be_doubles_of_a_table():
    assert espalier.Skeleton(np.eye(4, 3), np.array([-1.0, 0, 0, 1])).parents.tolist() == [-1, 0, 0, 1]


def test_mtg_goes_in_and_out_unchanged():
    text = fork().mtg()
    assert "/P1/N1\t" in text or "/P1\t" in text
    assert espalier.Skeleton.from_mtg(text).mtg() == text
    axes = fork().mtg(scales="plant-axis-node")
    assert axes != text and espalier.Skeleton.from_mtg(axes).mtg() == axes


def test_an_mtg_of_others_keeps_what_only_it_has():
    text = (
        "CODE:\tFORM-A\n\n"
        "CLASSES:\nSYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n"
        "$\t0\tFREE\tFREE\tIMPLICIT\nP\t1\tFREE\tFREE\tEXPLICIT\nU\t2\tFREE\tFREE\tEXPLICIT\n\n"
        "DESCRIPTION:\nLEFT\tRIGHT\tRELTYPE\tMAX\n\n"
        "FEATURES:\nNAME\tTYPE\nXX\tREAL\nYY\tREAL\nZZ\tREAL\nvigor\tALPHA\n\n"
        "MTG:\nENTITY-CODE\t\tXX\tYY\tZZ\tvigor\n"
        "/P1\t\t\t\t\t\n^/U1\t\t0\t0\t0\tgood # seen in May\n^<U2\t\t0\t0\t1\t\n\t+U1\t0\t1\t1.50\tpoor\n"
    )
    plant = espalier.Skeleton.from_mtg(text)
    assert plant.parents.tolist() == [-1, 0, 1]
    assert plant.edges.tolist() == ["<", "<", "+"]
    assert plant.mtg() == text


def test_a_broken_mtg_is_refused_by_line():
    with pytest.raises(espalier.Error, match="^mtg, line 1"):
        espalier.Skeleton.from_mtg("CODE:\tFORM-X\n")


def test_files_keep_the_skeleton(tmp_path):
    fork().write(tmp_path / "fork.mtg")
    assert (tmp_path / "fork.mtg").read_text() == fork().mtg()
    fork().write(tmp_path / "fork.swc")
    read = espalier.Skeleton.read(tmp_path / "fork.swc")
    assert read.parents.tolist() == fork().parents.tolist()
    with pytest.raises(espalier.Error, match="cannot be written with this extension"):
        fork().write(tmp_path / "fork.docx")


def test_openalea_reads_the_text(tmp_path):
    openalea = pytest.importorskip("openalea.mtg")
    fork().write(tmp_path / "fork.mtg")
    plant = openalea.MTG(str(tmp_path / "fork.mtg"))
    nodes = plant.vertices(scale=plant.max_scale())
    assert len(nodes) == 4
    heights = plant.property("ZZ")
    assert sorted(float(heights[node]) for node in nodes) == [0, 1, 1.5, 2]


@pytest.mark.parametrize(
    "change, line",
    [
        ({"parents": [-1, 0, 3, 1]}, "row 2: its parent, row 3, is no row before it: list parents "
         "before their children, and -1 for roots"),
        ({"parents": [-1, 0, 0.9, 1]}, "parents, row 2: write a whole number from -1 to 3, not 0.9"),
        ({"parents": [-7, 0, 1, 1]}, "parents, row 0: write a whole number from -1 to 3, not -7"),
        ({"parents": np.array([-1, 0, -2**40, 1])}, "parents, row 2: write a whole number from -1 "
         "to 3, not -1099511627776"),
        ({"parents": [-1, 0, 2**80, 1]}, "parents, row 2: write a whole number from -1 to 3, not "
         "1.20892581961463e+24"),
        ({"radii": [0, 0, 0, 1j]}, "radii are complex numbers: give real ones"),
        ({"positions": np.full((4, 3), 1j)}, "positions are complex numbers: give real ones"),
        ({"parents": [-1, 0]}, "parents have the shape (2,): give an array of shape (4,)"),
        ({"radii": [0, 0, 0, -1]}, "row 3: its radius is below 0: correct it"),
        ({"edges": ["<", "<", "<", "/"]}, "edges, row 3: write '<' for a successor or '+' for a "
         "branching, not '/'"),
        ({"positions": [[0, 0, 0], [0, 0, np.nan], [0, 0, 2], [0, 1, 1]]}, "row 1: its place or "
         "radius is beyond 1e12, as of no plant: correct or remove it"),
    ],
)
def test_what_is_no_skeleton_is_refused(change, line):
    arrays = {
        "positions": np.zeros((4, 3)), "parents": [-1, 0, 1, 1],
        "radii": [0, 0, 0, 0], "edges": ["<", "<", "<", "+"], **change,
    }
    with pytest.raises(espalier.Error) as refusal:
        espalier.Skeleton(**arrays)
    assert str(refusal.value) == line
