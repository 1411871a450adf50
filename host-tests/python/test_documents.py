"""The examples of docstrings and of docs/python.md, run as they stand."""
import doctest
import importlib
import os
import pathlib
import pkgutil
import re

import pytest

import stickband

SOURCE = pathlib.Path(os.environ["STICKBAND_SOURCE"])
MODULES = ["stickband"] + [f"stickband.{one.name}" for one in
                           pkgutil.iter_modules(stickband.__path__) if one.name != "_core"]


@pytest.mark.parametrize("name", MODULES)
def test_docstrings(name):
    found = doctest.testmod(importlib.import_module(name), verbose=False)
    assert found.failed == 0


def test_everything_public_has_a_docstring():
    for name in stickband.__all__:
        one = getattr(stickband, name)
        if name == "__version__":
            continue
        assert one.__doc__, name
        for key, member in vars(one).items() if isinstance(one, type) else ():
            if callable(member) and not key.startswith("_"):
                assert member.__doc__, f"{name}.{key}"


def test_the_tutorial(tmp_path, monkeypatch):
    """Every ```pycon block of the page, in one go."""
    pytest.importorskip("pandas")
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    page = (SOURCE / "docs" / "python.md").read_text()
    blocks = re.findall(r"^```pycon\n(.*?)^```", page, re.DOTALL | re.MULTILINE)
    assert len(blocks) > 5
    runner = doctest.DocTestRunner(
        optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    parsed = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, "python.md",
                                                 "docs/python.md", 0)
    told = []
    runner.run(parsed, out=told.append)
    assert runner.summarize(verbose=False).failed == 0, "".join(told)
