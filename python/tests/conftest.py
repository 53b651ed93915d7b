"""What tests share: small surfaces, the tool, and the public scans where they are."""

import json
import os
import pathlib
import subprocess

import numpy as np
import pytest

import brindle

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODELS = ROOT.parent / "shared" / "models"
TOOL = pathlib.Path(os.environ.get("BRINDLE_TOOL", ROOT / "build/release/apps/brindle/brindle"))


@pytest.fixture(scope="session")
def torus():
    return brindle.shape("torus", resolution=100)


@pytest.fixture(scope="session")
def square():
    """A unit square of two triangles, split into 2,048: (V, F)."""
    surface = brindle.Surface([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]],
                              [[0, 1, 2], [0, 2, 3]]).subdivided(5)
    return np.array(surface.vertices), np.array(surface.triangles)


@pytest.fixture(scope="session")
def horse():
    return model("horse.ply")


def model(name):
    if not (MODELS / name).exists():
        pytest.skip(f"{name} is not in ../shared/models")
    return brindle.read(MODELS / name)


def run_tool(*arguments):
    if not TOOL.exists():
        pytest.skip("the tool is not built; BRINDLE_TOOL names it")
    subprocess.run([TOOL, *map(str, arguments)], check=True, capture_output=True)


@pytest.fixture
def tool(tmp_path):
    """Runs a command of the tool with --report; returns the report."""

    def run(*arguments):
        report = tmp_path / "report.json"
        run_tool(*arguments, "--quiet", "--report", report)
        return json.loads(report.read_text())

    return run
