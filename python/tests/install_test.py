import os
import subprocess
import sys
from pathlib import Path


def test_it_is_imported_in_a_fresh_environment_from_its_package(tmp_path):
    build = os.environ["ESPALIER_BUILD"]
    subprocess.run(
        ["cmake", "--install", build, "--prefix", "/usr", "--component", "python"],
        env={**os.environ, "DESTDIR": str(tmp_path / "package")}, check=True, capture_output=True)
    environment = tmp_path / "environment"
    subprocess.run(
        [sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", environment],
        check=True)
    [packages] = environment.glob("lib/python3*/site-packages")
    [installed] = tmp_path.glob("package/usr/lib/python3/dist-packages/espalier")
    installed.rename(packages / "espalier")
    code = (
        "import espalier\n"
        "scan, truth = espalier.simulate(segments=20, points=2000)\n"
        "print(espalier.__file__, len(espalier.reconstruct(scan).skeleton) > 10)\n")
    done = subprocess.run(
        [environment / "bin/python", "-I", "-c", code], cwd=tmp_path, text=True,
        env={"PATH": "/usr/bin:/bin"}, capture_output=True)
    assert done.returncode == 0, done.stderr
    file, isFound = done.stdout.split()
    assert Path(file).parent == packages / "espalier" and isFound == "True"
    assert (packages / "espalier/py.typed").exists()
    assert (packages / "espalier/__init__.pyi").read_text().count("class ") > 30
