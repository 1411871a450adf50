"""The wheel in a fresh environment, and what Debian's package installs."""
import os
import pathlib
import subprocess
import sys

import pytest

SOURCE = pathlib.Path(os.environ["STICKBAND_SOURCE"])
BUILD = pathlib.Path(os.environ["STICKBAND_BUILD"])
USE = ("import stickband; loop = stickband.simulate('stiction', seed=1); "
       "print(stickband.__file__, stickband.__version__, stickband.identify(loop).verdict)")


def run(*command):
    clean = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    return subprocess.run(list(map(str, command)), check=True, capture_output=True,
                          text=True, env=clean).stdout


def test_wheel_in_a_fresh_environment(tmp_path):
    pytest.importorskip("venv")
    pytest.importorskip("ensurepip", reason="needs python3-venv")
    wheel = run(sys.executable, SOURCE / "python" / "make_wheel.py", BUILD / "python",
                SOURCE / "LICENSE", tmp_path / "dist").strip()
    again = run(sys.executable, SOURCE / "python" / "make_wheel.py", BUILD / "python",
                SOURCE / "LICENSE", tmp_path / "again").strip()
    assert pathlib.Path(wheel).read_bytes() == pathlib.Path(again).read_bytes()
    # NumPy is the machine's own: the package index cannot be counted on.
    run(sys.executable, "-m", "venv", "--system-site-packages", tmp_path / "env")
    python = tmp_path / "env" / "bin" / "python"
    run(python, "-m", "pip", "install", "--no-index", "--no-deps", wheel)
    assert "stickband" in run(python, "-m", "pip", "show", "stickband")
    file, version, verdict = run(python, "-c", USE).split()
    assert file.startswith(str(tmp_path / "env")) and verdict == "stiction"
    assert version in pathlib.Path(wheel).name
    run(python, "-m", "pip", "uninstall", "-y", "stickband")
    assert not (pathlib.Path(file).parent).exists()


def test_a_folder_of_two_versions_is_refused(tmp_path):
    for version in ("1.0.0", "1.1.0"):
        (tmp_path / f"stickband-{version}.dist-info").mkdir()
    told = subprocess.run([sys.executable, SOURCE / "python" / "make_wheel.py", tmp_path,
                           SOURCE / "LICENSE", tmp_path / "dist"], capture_output=True,
                          text=True)
    assert told.returncode != 0 and "expected one .dist-info folder" in told.stderr
    assert "stickband-1.0.0.dist-info, stickband-1.1.0.dist-info" in told.stderr


def test_layout_of_the_debian_package(tmp_path):
    run("cmake", "--install", BUILD, "--component", "python", "--prefix", tmp_path / "usr")
    packages = tmp_path / "usr" / "lib" / "python3" / "dist-packages"
    names = sorted(path.name for path in (packages / "stickband").iterdir())
    assert "__init__.py" in names and "py.typed" in names and "_core.pyi" in names
    assert any(name.startswith("_core.cpython-") and name.endswith(".so") for name in names)
    assert list(packages.glob("stickband-*.dist-info/METADATA"))
    told = run(sys.executable, "-c", f"import sys; sys.path.insert(0, {str(packages)!r}); {USE}")
    assert told.split()[0].startswith(str(packages))
