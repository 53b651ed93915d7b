"""What tests share: small surfaces, the tool, and the public scans where they are."""

import json
import os
import pathlib
import re
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
                              [[0, 1, 2], [0, 2, 3]]).subdivide(5)
    return np.array(surface.vertices), np.array(surface.faces)


@pytest.fixture(scope="session")
def horse():
    return model("horse.ply")


def model(name):
    if not (MODELS / name).exists():
        pytest.skip(f"{name} is not in ../shared/models")
    return brindle.read(MODELS / name)


# Arguments that the tool has in the values of other options: the option, its default, and what stands
# before the value.
PARTS = {
    **{key: ("solver", "multilevel", f",{key}=")
       for key in ("phase-shift", "weights", "sweeps", "cycles", "epsilon", "momentum", "seed")},
    "global-iterations": ("solver", "multilevel", ",iterations="),
    "lambda": ("previous", "", ",lambda="),
    "match": ("previous", "", ",match="),
    "cancel-distance": ("cancel-branches", "", ",distance="),
    "curvature-direction": ("field", "smooth", ","),
    "feature-angle": ("feature-anchor", 0, ",angle="),
    "feature-radius": ("feature-anchor", 0, ",radius="),
    "fill": ("field-smoothing", 0, ",fill="),
    "field-arrows": ("field-smoothing", 0, ",arrows"),
    "field-singularities": ("field-smoothing", 0, ",singularities="),
    "field-weight": ("field-smoothing", 0, ",weight="),
    "rounded": ("subdivide", 0, ",rounded"),
    "frequency-range": ("frequency-by", "", "@"),
}


def command_words(options):
    """The tool's words for options by their names; True for flags."""
    values = {name: value for name, value in options.items() if name not in PARTS}
    for name, value in options.items():
        if name in PARTS:
            whole, default, before = PARTS[name]
            values[whole] = f"{values.get(whole, default)}{before}{'' if value is True else value}"
    return [f"--{name}" if value is True else f"--{name}={value}" for name, value in values.items()]


def with_names_of_parts(message):
    """What the tool says, with --epsilon instead of --solver ...,epsilon=E."""
    for name, (whole, _, before) in PARTS.items():
        form = "max|min" if name == "curvature-direction" else ""
        written = re.escape(f"--{whole} ...{before}{form}")
        message = re.sub(rf"{written}\S*?(?=[:;,]?(?:\s|$))", f"--{name}", message)
    return message


def grouped(stripes_v=None, frequency_v=None, **options):
    """Arguments of Python of options by the tool's names: in the groups that they belong to."""
    def take(kind, *more):
        names = [*vars(kind())] + list(more)
        return {name: options.pop(name) for name in names if name in options}

    solver = options.pop("solver", None)
    parameters = take(brindle.Solver)
    if parameters:
        solver = brindle.Solver(solver, **parameters)
    groups = {"solver": solver}
    for name, kind in (("layout", brindle.Layout), ("measured", brindle.Measured), ("look", brindle.Look)):
        given = take(kind)
        groups[name] = kind(**given) if given else None
    if "avoid_branches" in options:
        options["slack"] = brindle.Slack(options.get("slack"), options.pop("avoid_branches"))
    previous = {name: options.pop(name) for name in ("stiffness", "match") if name in options}
    if previous:
        options["previous"] = brindle.Previous(options.get("previous"), **previous)
    if options.pop("along", False):
        options["run"] = "along"
    for name, of_v in (("stripes", stripes_v), ("frequency", frequency_v)):
        if stripes_v is not None or frequency_v is not None:
            options[name] = (options.get(name), of_v)
    return options | {name: group for name, group in groups.items() if group is not None}


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
