"""The stubs say what the module has; the package passes mypy."""
import ast
import importlib.util
import os
import pathlib
import subprocess
import sys

import pytest

from stickband import _core

PACKAGE = pathlib.Path(os.environ["STICKBAND_SOURCE"]) / "python" / "stickband"


def public(names):
    return {name for name in names if not name.startswith("_")}


def test_stub_has_every_name_of_the_module():
    tree = ast.parse((PACKAGE / "_core.pyi").read_text())
    stubs = {node.name: node for node in tree.body
             if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    assert set(stubs) == public(vars(_core))
    for name, node in stubs.items():
        if isinstance(node, ast.ClassDef):
            members = {one.name for one in node.body if isinstance(one, ast.FunctionDef)}
            members |= {one.target.id for one in node.body if isinstance(one, ast.AnnAssign)}
            assert public(members) == public(vars(getattr(_core, name))), name


@pytest.mark.skipif(importlib.util.find_spec("mypy") is None, reason="install python3-mypy")
def test_mypy():
    run = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports",
         "--no-incremental", "--cache-dir=/dev/null", str(PACKAGE)],
        capture_output=True, text=True)
    assert run.returncode == 0, run.stdout
