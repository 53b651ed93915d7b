"""Requests by chance, over the options that the doors share: the tool, Python, a session and one rank
of MPI give the same metrics, bit for bit, or refuse in the same words. BRINDLE_REQUESTS says how many
(500)."""

import json
import os
import random
import shutil
import subprocess
import warnings

import pytest

import brindle
from brindle import _core
from conftest import TOOL, command_words, grouped, with_names_of_parts

COUNT = int(os.environ.get("BRINDLE_REQUESTS", "500"))
PER_TEST = 25  # so that tests can be told from each other, and end soon
RANK_EVERY = 10  # ranks take half a second to start
MPIRUN = [shutil.which("mpirun"), "--oversubscribe", "--allow-run-as-root", "-n", "1"]

SHAPES = ["torus,resolution=16", "trefoil,resolution=12", "sphere,resolution=10", "box,resolution=8",
          "plane,resolution=12"]
OWN_KEYS = {"command", "input", "options", "milliseconds", "threads"}


def number(chance, low, high):
    return float(f"{chance.uniform(low, high):.3g}")


# What both have under the same name: an option of the tool, an argument of Python.
SHARED = {
    "stripes": lambda c: number(c, 2, 30),
    "frequency": lambda c: number(c, 0.5, 8),
    "along": lambda c: True,
    "solver": lambda c: c.choice(["multilevel", "relaxation", "averaged", "global"]),
    "phase_shift": lambda c: c.choice(["aligned", "common_source", "trapezoid"]),
    "weights": lambda c: c.choice(["paper", "cotangent"]),
    "epsilon": lambda c: number(c, 0.001, 0.5),
    "momentum": lambda c: number(c, 0, 0.9),
    "seed": lambda c: c.randint(0, 50),
    "sweeps": lambda c: c.randint(0, 12),
    "cycles": lambda c: c.randint(0, 5),
    "global_iterations": lambda c: c.randint(1, 6),
    "slack": lambda c: number(c, 0, 0.6),
    "cancel_branches": lambda c: number(c, 0, 0.3),
    "cancel_distance": lambda c: number(c, 1, 30),
}
OF_STRIPES = {
    "anchor_boundary": lambda c: number(c, 0, 1),
    "winding": lambda c: c.randint(-3, 3),
}
OF_TEXTURES = {
    "oriented": lambda c: True,
    "stripes_v": lambda c: number(c, 2, 30),
    "frequency_v": lambda c: number(c, 0.5, 8),
}
OF_MEASURED = {
    "fill": lambda c: number(c, 0, 5),
    "field_arrows": lambda c: True,
    "field_singularities": lambda c: c.randrange(30),
}
FIELDS = {
    "curvature-direction": lambda c: "min",  # "max" is what Python has unless it is told
    "curvature-anchor": lambda c: number(c, 0, 2),
    "feature-anchor": lambda c: number(c, 0, 2),
    "feature-angle": lambda c: number(c, 1, 179),
    "feature-radius": lambda c: number(c, 0.01, 0.5),
    "normal-radius": lambda c: number(c, 0.01, 0.5),
}


# Values that no request can have, one at a time: what is refused first is another question.
WRONG = [("stripes", -1.0), ("stripes", 0.0), ("frequency", 0.0), ("frequency", -2.0), ("slack", -0.5),
         ("solver", "other"), ("phase_shift", "none"), ("weights", "equal"), ("sweeps", 99999),
         ("cycles", 99999), ("cancel_branches", -1.0), ("cancel_distance", 0.0), ("field_smoothing", -1.0), ("fill", -0.5),
         ("field_singularities", -1)]


def chosen(chance, options, most):
    names = chance.sample(sorted(options), chance.randint(0, min(most, len(options))))
    for one, other in (("stripes", "frequency"), ("stripes_v", "frequency_v")):
        if one in names and other in names:
            names.remove(other)
    return {name: options[name](chance) for name in names}


class Request:
    """Words for the tool, and the same for Python."""

    def __init__(self, seed):
        chance = random.Random(seed)
        self.shape = chance.choice(SHAPES)
        self.job = chance.choice(["stripes", "stripes", "texture", "crosses"])
        options = dict(SHARED)
        options.update({"stripes": OF_STRIPES, "texture": OF_TEXTURES, "crosses": {}}[self.job])
        if self.job == "crosses":
            del options["along"]  # the tool refuses it, Python does not have it
        self.options = chosen(chance, options, 4)
        self.field = chance.choice(["", "", "smooth", "direction", "curvature", "raw-curvature"])
        self.of_field = chosen(chance, FIELDS, 2) if self.field != "direction" and chance.random() < 0.4 else {}
        if self.field == "raw-curvature":
            self.of_field = {name: "min" for name in self.of_field if name == "curvature-direction"}
        if self.field == "raw-curvature" and chance.random() < 0.7:
            self.options.update(chosen(chance, OF_MEASURED, 2), field_smoothing=number(chance, 0.1, 3))
            if self.job == "crosses":
                self.options.pop("field_arrows", None)  # as with along
        # The tool turns once by both: what comes of it differs by rounding.
        turns = chance.random() < 0.2 and not {"along", "field_smoothing"} & self.options.keys()
        self.rotate = float(chance.randint(-90, 90)) if turns else None

        if chance.random() < 0.08:
            name, value = chance.choice(WRONG)
            self.job, self.field, self.of_field, self.rotate = "stripes", "", {}, None
            self.options = {name: value}
        # The tool has it in the value of the other.
        if "cancel_distance" in self.options:
            self.options.setdefault("cancel_branches", 0.1)

    def given(self):
        """Options of the tool, by their names without dashes; True for flags."""
        given = {name.replace("_", "-"): value for name, value in {**self.options, **self.of_field}.items()}
        if self.field == "direction":
            given["direction"] = "0.31,0.9,0.27"
        elif self.field:
            given["field"] = self.field
        if self.rotate is not None:
            given["rotate"] = self.rotate
        return given | {"stripes": {}, "texture": {"texture": "dots"}, "crosses": {"cross": True}}[self.job]

    def words(self):
        return ["stripe", f"shape:{self.shape}", *command_words(self.given())]

    def session(self):
        options = {name: value if value is True else str(value) for name, value in self.given().items()}
        return {"brindle_session": 1, "mesh": f"shape:{self.shape}", "options": options}

    def directions(self, surface):
        given = {name.replace("-", "_"): value for name, value in self.of_field.items()}
        kind = given.pop("curvature_direction", None)
        symmetry = {"symmetry": 4} if self.job == "crosses" else {}
        if self.field == "direction":
            field = surface.projected_field((0.31, 0.9, 0.27))
        elif self.field in ("curvature", "raw-curvature"):
            if "curvature_anchor" in given:
                given["anchor"] = given.pop("curvature_anchor")
            if self.field == "raw-curvature":
                given["raw"] = True
                symmetry = {}
            field = surface.curvature_field(kind or "max", **symmetry, **given)
        elif given or kind or self.rotate is not None or self.field:
            field = surface.smooth_field(curvature=kind or "max", **symmetry, **given)
        else:
            return None
        return field if self.rotate is None else surface.rotate_field(field, self.rotate)

    def ask(self, surface):
        made = {"stripes": brindle.stripes, "texture": brindle.texture, "crosses": brindle.crosses}[self.job]
        return made(surface, self.directions(surface), **grouped(**self.options)).report


def answer_of(words, path):
    """A report, or why there is none."""
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode in (0, 1, 2), f"{words}: {done.stderr}"
    if done.returncode == 0:
        return json.loads(path.read_text()), None
    lines = [line for line in done.stderr.strip().splitlines()
             if line.startswith("brindle: ") and not line.endswith("tells more")]
    return None, with_names_of_parts(lines[-1])


def answer_of_tool(request, path):
    return answer_of([TOOL, *request.words(), "--report", path], path)


def answer_of_session(request, path):
    file = path.with_name("session.json")
    file.write_text(json.dumps(request.session()))
    return answer_of([TOOL, "render", file, "--quiet", "--output", path], path)


def has_mpi():
    return "MPI" in subprocess.run([TOOL, "--version"], capture_output=True, text=True, check=True).stdout


def answer_of_rank(request, path):
    return answer_of([*MPIRUN, TOOL, *request.words(), "--quiet", "--report", path, "--output",
                      path.with_name("pieces.pvtp")], path)


def answer_of_python(request):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return request.ask(brindle.shape(request.shape)), None
        except (brindle.Error, TypeError) as refused:
            return None, str(refused)


def check_same(said, report, expected):
    for key in report.keys() - OWN_KEYS:
        assert report[key] == expected[key], f"{said}: {key}"


def check_session(said, request, path, expected, refusal):
    report, refused = answer_of_session(request, path)
    assert (report is None) == (expected is None), f"{said}: {refused}"
    if refusal is not None:
        # What the session's file is called, and of which command its options are, may stand before.
        assert refused.endswith(refusal.removeprefix("brindle: ")), said
    else:
        assert report.keys() - OWN_KEYS == expected.keys() - OWN_KEYS, said
        check_same(said, report, expected)


def check_rank(said, request, path, expected, refusal):
    report, refused = answer_of_rank(request, path)
    if refusal is not None:
        assert refused is not None, said
    elif refused is not None:
        assert "in one process" in refused or "not expected: --" in refused, f"{said}: {refused}"
    else:
        check_same(said, {key: report[key] for key in report.keys() - {"ranks"}}, expected)


@pytest.mark.parametrize("first", range(0, COUNT, PER_TEST))
def test_requests(first, tmp_path):
    if not TOOL.exists():
        pytest.skip("the tool is not built; BRINDLE_TOOL names it")
    path = tmp_path / "report.json"
    made = 0
    for seed in range(first, first + PER_TEST):
        request = Request(seed)
        said = f"request {seed}: {' '.join(request.words())}"
        expected, refusal = answer_of_tool(request, path)
        report, refused = answer_of_python(request)
        in_pythons_words = None if refusal is None else _core.in_pythons_words(refusal.removeprefix("brindle: "))
        assert refused == in_pythons_words, said
        if refusal is None:
            made += 1
            check_same(said, report, expected)
        check_session(said, request, path, expected, refusal)
    assert made > 0


@pytest.mark.parametrize("first", range(0, COUNT // RANK_EVERY, PER_TEST))
def test_requests_of_one_rank(first, tmp_path):
    if not TOOL.exists() or MPIRUN[0] is None or not has_mpi():
        pytest.skip("the tool is not built with MPI; ./dev mpi builds it")
    path = tmp_path / "report.json"
    for seed in range(RANK_EVERY * first, RANK_EVERY * (first + PER_TEST), RANK_EVERY):
        request = Request(seed)
        said = f"request {seed}: {' '.join(request.words())}"
        check_rank(said, request, path, *answer_of_tool(request, path))
