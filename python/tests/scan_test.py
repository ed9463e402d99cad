import gc

import numpy as np
import pytest

import espalier


def test_points_come_back_in_the_order_of_space(plant):
    scan = espalier.Scan(plant.points)
    assert len(scan) == len(plant.points)
    assert scan.positions.dtype == np.float32 and scan.positions.shape == plant.points.shape
    assert sorted(scan.order) == list(range(len(plant.points)))
    np.testing.assert_allclose(
        scan.positions + scan.origin, plant.points[scan.order], rtol=0, atol=1e-6
    )


@pytest.mark.parametrize("layout", ["rows", "columns", "every other", "reversed", "list"])
def test_the_layout_of_the_array_does_not_matter(plant, layout):
    expected = espalier.Scan(plant.points).positions
    given = {
        "rows": np.ascontiguousarray(plant.points),
        "columns": np.asfortranarray(plant.points),
        "every other": np.repeat(plant.points, 2, axis=0)[::2],
        "reversed": plant.points[::-1],
        "list": plant.points.tolist(),
    }[layout]
    assert np.array_equal(espalier.Scan(given).positions, expected)


def test_floats_and_integers_are_points_too():
    numbers = np.arange(30).reshape(10, 3) ** 2
    expected = espalier.Scan(numbers.astype(float)).positions
    for kind in (np.float32, np.int64, np.int16):
        assert np.array_equal(espalier.Scan(numbers.astype(kind)).positions, expected)


def test_arrays_are_views_that_can_only_be_read(plant):
    scan = espalier.Scan(
        plant.points,
        colors=np.full(plant.points.shape, 7),
        intensities=np.arange(len(plant.points)),
    )
    for name in ("positions", "origin", "order", "colors", "intensities"):
        array = getattr(scan, name)
        assert np.shares_memory(array, getattr(scan, name)), name
        assert not array.flags.owndata and not array.flags.writeable, name
        with pytest.raises(ValueError):
            array.setflags(write=True)
    assert np.array_equal(scan.intensities, scan.order)
    assert (scan.colors == 7).all()


def test_views_outlive_the_scan(plant):
    positions = espalier.Scan(plant.points).positions
    before = positions.copy()
    gc.collect()
    espalier.Scan(plant.points[::-1] + 1)
    assert np.array_equal(positions, before)


def test_the_scan_does_not_follow_the_array(plant):
    points = plant.points.copy()
    scan = espalier.Scan(points)
    before = scan.positions.copy()
    points[:] = 0
    assert np.array_equal(scan.positions, before)


def test_points_that_are_not_finite_are_left_out(plant):
    points = plant.points.copy()
    points[5, 1] = np.nan
    points[9, 2] = np.inf
    scan = espalier.Scan(points)
    assert len(scan) == len(points) - 2
    assert not {5, 9} & set(scan.order.tolist())
    assert scan.notes[0].startswith(f"points: 2 of {len(points)} points are not finite")


@pytest.mark.parametrize(
    "points, line",
    [
        (np.zeros((5, 2)), "points have the shape (5, 2): give an array of shape (n, 3)"),
        (np.zeros(6), "points have the shape (6,): give an array of shape (n, 3)"),
        ([["a", "b", "c"]], "points are no numbers: give an array of them"),
        ([[1j, 0, 0]], "points are complex numbers: give real ones"),
        (np.zeros((4, 3), np.complex64), "points are complex numbers: give real ones"),
        (np.zeros((0, 3)), "points hold 0 rows, none of them finite: give the points of a scan"),
        (np.ma.masked_greater(np.arange(6.0).reshape(2, 3), 4),
         "points are masked in part: give those that count, as array.data[rows]"),
        (np.full((2, 3), np.nan), "points hold 2 rows, none of them finite: give the points of a scan"),
    ],
)
def test_what_is_no_scan_is_refused(points, line):
    with pytest.raises(espalier.Error) as refusal:
        espalier.Scan(points)
    assert str(refusal.value) == line


def test_colors_of_other_length_are_refused(plant):
    with pytest.raises(espalier.Error, match=r"colors have the shape \(1, 3\)"):
        espalier.Scan(plant.points, colors=np.zeros((1, 3)))


@pytest.mark.parametrize("wrong", [0.7, 300, -1, 255.5, np.nan])
def test_colors_that_are_no_bytes_are_refused(plant, wrong):
    colors = np.zeros(plant.points.shape)
    colors[7, 1] = wrong
    with pytest.raises(espalier.Error) as refusal:
        espalier.Scan(plant.points, colors=colors)
    assert str(refusal.value) == f"colors, row 7: write a whole number from 0 to 255, not {wrong}"


@pytest.mark.parametrize("kind", [np.uint8, np.int64, np.float64])
def test_colors_are_whole_numbers_of_any_type(plant, kind):
    colors = np.arange(plant.points.size).reshape(plant.points.shape) % 256
    scan = espalier.Scan(plant.points, colors=np.asfortranarray(colors.astype(kind)))
    assert np.array_equal(scan.colors, colors[scan.order])


def test_files_give_the_points_that_were_written(plant, tmp_path):
    scan = espalier.Scan(plant.points, intensities=plant.points[:, 2])
    scan.write(tmp_path / "scan.ply")
    read = espalier.Scan.read(tmp_path / "scan.ply")
    assert np.array_equal(read.positions + read.origin, scan.positions + scan.origin)
    assert np.array_equal(read.intensities, scan.intensities)
    assert np.array_equal(read.order, scan.order)
    with pytest.raises(espalier.Error, match="missing.ply"):
        espalier.Scan.read(tmp_path / "missing.ply")
