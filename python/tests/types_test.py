import os
import subprocess
import sys
from pathlib import Path

import espalier

FOLDER = Path(espalier.__file__).parent


def checked(*arguments, tmp_path, **variables):
    return subprocess.run(
        [sys.executable, "-m", *map(str, arguments)],
        env={**os.environ, "MYPYPATH": str(FOLDER.parent), **variables},
        capture_output=True, text=True, cwd=tmp_path,
    )


# These come from functions alone: what they are called with is no part of their types.
WITHOUT_CONSTRUCTOR = (
    "StepRecord", "Reconstruction", "EndDecision", "GapAlternative", "GapDecision", "Alternative",
    "Doubt", "Decisions", "Evaluation")


def test_the_types_are_those_of_the_module(tmp_path):
    allowed = tmp_path / "allowed"
    allowed.write_text("".join(f"espalier.{name}.__init__\n" for name in WITHOUT_CONSTRUCTOR))
    done = checked("mypy.stubtest", "--allowlist", allowed, "espalier", tmp_path=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


RIGHT = """
import numpy as np
from numpy.typing import NDArray
import espalier

def noted(fraction: float, stage: str) -> None: ...

scan = espalier.Scan(np.zeros((3, 3)), progress=noted)
options = espalier.Options("thesis", unit="mm")
options.contract.method = "adaptive_geodesic"
options.contract.least_radius = "6 spacings"
options.skeleton.reach = 2.5
plant = espalier.reconstruct(scan, options, threads=2)
radii: NDArray[np.float64] = plant.skeleton.radii
f: float | None = espalier.evaluate(plant.skeleton, plant.skeleton).scores["f"]
chances: list[float] = [end.probability for end in espalier.decisions(plant).ends]
"""

WRONG = [
    "espalier.reconstruct(np.zeros((3, 3)))",
    "espalier.Options().contract.method = 'best'",
    "espalier.Options().contrct",
    "espalier.Options().skeleton.reach = 'far'",
    "espalier.Options(unit='ft')",
    "espalier.simulate(seed='7')",
]


def test_types_accept_what_is_right_and_nothing_else(tmp_path):
    right = tmp_path / "right.py"
    right.write_text(RIGHT)
    wrong = tmp_path / "wrong.py"
    wrong.write_text("import numpy as np\nimport espalier\n" + "\n".join(WRONG) + "\n")
    done = checked("mypy", "--strict", right, wrong, tmp_path=tmp_path)
    errors = [line for line in done.stdout.splitlines() if ": error: " in line]
    lines = {int(line.split(":")[1]) for line in errors if line.startswith("wrong.py:")}
    assert lines == set(range(3, 3 + len(WRONG))), done.stdout
    assert not [line for line in errors if line.startswith("right.py:")], done.stdout
