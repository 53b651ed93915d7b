"""The examples of the pages, and the tour, run as they stand."""

import ast
import os
import pathlib
import re
import shlex
import subprocess
import sys
import types

import numpy as np
import pytest

import brindle
from conftest import ROOT, run_tool

PAGE = (ROOT / "docs/python.md").read_text()
MOVING = (ROOT / "docs/animate.md").read_text()
BLOCKS = re.findall(r"^```python\n(.*?)^```", PAGE + MOVING, re.DOTALL | re.MULTILINE)
TOUR = sorted((ROOT / "python/tour").glob("*.py"))


class Polyscope(types.ModuleType):
    """Takes what Polyscope takes, and looks at it."""

    def __init__(self):
        super().__init__("polyscope")
        self.registered = []

    def init(self):
        pass

    def show(self):
        assert self.registered == ["torus", "texture", "stripes"]

    def register_surface_mesh(self, name, vertices, faces):
        assert vertices.shape[1] == faces.shape[1] == 3 and faces.max() < len(vertices)
        self.registered.append(name)

        def add(quantity, values, defined_on):
            assert defined_on == "corners" and values.shape == (3 * len(faces), 2)
            self.registered.append(quantity)

        return types.SimpleNamespace(add_parameterization_quantity=add)

    def register_curve_network(self, name, nodes, edges):
        assert nodes.shape[1] == 3 and edges.shape[1] == 2 and edges.max() < len(nodes)
        self.registered.append(name)


def run(source, folder, monkeypatch):
    monkeypatch.chdir(folder)
    monkeypatch.setenv("MPLBACKEND", "agg")
    scope = {"__name__": "__main__"}
    exec(compile(source, "example", "exec"), scope)
    return scope


def needs(source):
    for package in ("meshio", "matplotlib", "vtk"):
        if re.search(rf"^import {package}|^from {package}", source, re.MULTILINE):
            pytest.importorskip(package)
    if re.search(r"render\(|write_png\(", source) and not brindle.has_opengl:
        pytest.skip("this build draws no pictures")


@pytest.mark.parametrize("source", BLOCKS, ids=[f"block {i}" for i in range(len(BLOCKS))])
def test_page(source, tmp_path, monkeypatch):
    needs(source)
    monkeypatch.setitem(sys.modules, "polyscope", Polyscope())
    lines = [line for line in source.splitlines() if line and not line.startswith("import ")]
    assert len(lines) <= 12, "ten lines or so"
    run(source, tmp_path, monkeypatch)


@pytest.mark.parametrize("script", TOUR, ids=[script.stem for script in TOUR])
def test_tour(script, tmp_path, monkeypatch):
    source = script.read_text()
    needs(source)
    assert source.count("\n# %%") >= 3, "cells"
    run(source, tmp_path, monkeypatch)
    assert any(tmp_path.iterdir()), "it leaves something to look at"


@pytest.mark.skipif(not brindle.has_opengl, reason="this build draws no pictures")
def test_picture_of_the_page(tmp_path, monkeypatch):
    """The page's Python and the page's command draw the same."""
    run(BLOCKS[0], tmp_path, monkeypatch)
    made = brindle.read_png(tmp_path / "python.png")
    command = re.search(r"^brindle (stripe .*python.png)$", PAGE, re.MULTILINE).group(1)
    run_tool(*shlex.split(command))
    np.testing.assert_array_equal(made, brindle.read_png(tmp_path / "python.png"))


def test_everything_public_is_documented_and_typed():
    everything = [(brindle, name) for name in brindle.__all__]
    everything += [(brindle.advanced, name) for name in brindle.advanced.__all__]
    for module, name in everything:
        thing = getattr(module, name)
        assert name == "has_opengl" or (thing.__doc__ or "").strip(), name
        if not isinstance(thing, type) or issubclass(thing, Exception):
            continue
        for member, value in vars(thing).items():
            if member.startswith("_"):
                continue
            value = getattr(value, "fget", None) or getattr(value, "func", None) or getattr(
                value, "__func__", value)
            if not callable(value):
                continue  # a default of a group of options
            assert (value.__doc__ or "").strip(), f"{name}.{member}"
            assert "return" in value.__annotations__, f"{name}.{member}"


def test_stubs_name_all_there_is():
    """They are made of the module that was built (make_stubs.py)."""
    folder = pathlib.Path(brindle.__file__).parent
    said = set(re.findall(r"import (\w+) as \1", (folder / "__init__.pyi").read_text()))
    assert said == {*brindle.__all__, "advanced"} and (folder / "py.typed").exists()
    stub = ast.parse((folder / "_core.pyi").read_text())
    classes = {node.name: {member.name for member in node.body if hasattr(member, "name")}
               for node in stub.body if isinstance(node, ast.ClassDef)}
    core = sys.modules["brindle._core"]
    for name, value in vars(core).items():
        if isinstance(value, type) and value.__module__ == "brindle._core":
            assert {member for member in vars(value) if not member.startswith("_")} <= classes[name], name
    assert "handle" not in (folder / "_core.pyi").read_text()


def test_importing_loads_nothing_heavy():
    """Neither numpy nor the C++ side; the rest is measured by hand: no test has a time limit."""
    done = subprocess.run(
        [sys.executable, "-c", "import sys; before = set(sys.modules); import brindle; "
         "print(*(set(sys.modules) - before))"], capture_output=True, text=True, check=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
    loaded = done.stdout.split()
    assert "brindle" in loaded and "numpy" not in loaded and "brindle._core" not in loaded


def test_version_is_that_of_the_headers():
    header = (ROOT / "include/brindle/version.h").read_text()
    assert f'"{brindle.__version__}"' in header
