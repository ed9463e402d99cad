"""What the tests share: a simulated plant, its scan as the arrays of others, and the program."""

import os
import subprocess
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

import espalier

PROGRAM = os.environ["ESPALIER_PROGRAM"]


class Plant(NamedTuple):
    points: np.ndarray  # doubles, in no order
    truth: espalier.Skeleton
    file: Path  # the same points as text


def run(*arguments) -> str:
    """What the program writes to standard error; it must succeed."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stderr


def refused(*arguments) -> str:
    """The one line with which the program refuses, without its name and where to read on."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode != 0
    lines = [line for line in done.stderr.splitlines() if line.startswith("espalier: ")]
    assert len(lines) == 1, done.stderr
    return lines[0].removeprefix("espalier: ").removesuffix(f'; see "espalier {arguments[0]} --help"')


@pytest.fixture(scope="session")
def plant(tmp_path_factory) -> Plant:
    scan, truth = espalier.simulate(seed=3, segments=60, points=6000)
    points = scan.positions + scan.origin
    np.random.default_rng(1).shuffle(points)
    file = tmp_path_factory.mktemp("plant") / "plant.xyz"
    file.write_text("".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in points.tolist()))
    return Plant(points, truth, file)


@pytest.fixture(scope="session")
def found(plant) -> espalier.Reconstruction:
    return espalier.reconstruct(espalier.Scan(plant.points))
