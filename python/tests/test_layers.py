"""The package's shape: imports in one direction, short signatures, options that are rows."""

import ast
import inspect
import pathlib

import pytest

import brindle
from brindle import _core, _options

FOLDER = pathlib.Path(brindle.__file__).parent
# Each imports only those before it.
LAYERS = ["_core", "_arguments", "_options", "_interop", "_look", "_surface", "_inputs", "_outputs", "_paths", "_relief",
          "_patterns", "_pictures", "_animate", "advanced"]
FEW = 12


def imports(tree):
    """The modules of the package that a module imports."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.level > 0:
            yield from [node.module] if node.module else [alias.name for alias in node.names]


def test_all_modules_have_a_layer():
    assert {path.stem for path in FOLDER.glob("*.py")} == {*LAYERS, "__init__"} - {"_core"}


@pytest.mark.parametrize("name", LAYERS[1:])
def test_imports_run_in_one_direction(name):
    tree = ast.parse((FOLDER / f"{name}.py").read_text())
    assert set(imports(tree)) <= set(LAYERS[:LAYERS.index(name)])


@pytest.mark.parametrize("name", LAYERS[1:])
def test_no_import_within_functions(name):
    """Packages that may be missing go through one function of _interop."""
    tree = ast.parse((FOLDER / f"{name}.py").read_text())
    functions = [node for node in ast.walk(tree) if isinstance(node, (ast.FunctionDef, ast.Lambda))]
    within = [node for function in functions for node in ast.walk(function)
              if isinstance(node, (ast.Import, ast.ImportFrom))
              or isinstance(node, ast.Attribute) and node.attr == "import_module" and name != "_interop"]
    assert not within


def callables():
    for module in (brindle, brindle.advanced):
        for name in module.__all__:
            thing = getattr(module, name)
            if inspect.isclass(thing):
                yield f"{name}()", thing
                for member, value in vars(thing).items():
                    if callable(value) and not member.startswith("_"):
                        yield f"{name}.{member}", value
            elif callable(thing):
                yield name, thing


def test_signatures_are_short():
    counts = {}
    for name, thing in callables():
        try:
            counts[name] = len([p for p in inspect.signature(thing).parameters if p != "self"])
        except ValueError:
            assert issubclass(thing, Exception)
    assert {name: count for name, count in counts.items() if count > FEW} == {}
    assert counts["stripes"] == FEW and "Surface.smooth_field" in counts


@pytest.mark.parametrize("name", _options.GROUPS)
def test_groups_are_rows_of_options(name):
    """Types and ranges are those of the rows, and checked where fields are given."""
    kind = getattr(brindle, name)
    assert kind().given() == {}
    for field in kind.__dataclass_fields__:
        row = _options.ROWS[kind._OPTION_OF.get(field, field)]
        if row["kind"] == "choice":
            for word in row["form"].split("|"):
                kind(**{field: word})
            with pytest.raises(brindle.Error, match=f"expected one of {row['form'].split('|')[0]}"):
                kind(**{field: "other"})
        elif row["kind"] in ("number", "whole"):
            for wrong in (float("nan"), float("inf")):
                with pytest.raises((brindle.Error, TypeError)):
                    kind(**{field: wrong})
            with pytest.raises(TypeError):
                kind(**{field: "1"})
        elif row["kind"] == "flag":
            with pytest.raises(TypeError):
                kind(**{field: 1})
        assert f"``{field}``" in kind.__doc__
    with pytest.raises(TypeError, match="nonsense"):
        kind(nonsense=1)


def test_groups_are_frozen_and_of_their_parameter(torus):
    solver = brindle.Solver("relaxation", epsilon=0.1)
    with pytest.raises(AttributeError):
        solver.epsilon = 0.2
    assert solver.given() == {"solver": "relaxation", "epsilon": 0.1}
    for wrong in ({"layout": solver}, {"measured": solver}, {"solver": brindle.Layout()}, {"solver": 3}):
        with pytest.raises(TypeError, match=f"{[*wrong][0]}: expected"):
            brindle.stripes(torus, **wrong)
    with pytest.raises(TypeError, match="look: expected brindle.Look"):
        brindle.render(torus, look=solver)


def test_options_without_effect_are_rejected(torus):
    for solver in (brindle.Solver(epsilon=0.1), brindle.Solver(iterations=3)):
        with pytest.raises(brindle.Error, match="has no effect here"):
            brindle.stripes(torus, solver=solver)
    for solver in (brindle.Solver(epsilon=0.1), brindle.Solver(iterations=3), brindle.Solver(threads=1),
                   brindle.Solver("relaxation", sweeps=2)):
        with pytest.raises(brindle.Error, match="has no effect here"):
            brindle.Animator(torus, solver=solver)
    for solver in ("relaxation", brindle.Solver(phase_shift="trapezoid"), brindle.Solver(seed=1)):
        with pytest.raises(brindle.Error, match="has no effect here"):
            brindle.TextureAnimator(torus, solver=solver)
    for layout in (brindle.Layout(winding=1), brindle.Layout(anchor_boundary=0)):
        with pytest.raises(brindle.Error, match="has no effect here: it is for stripes, not for textures"):
            brindle.texture(torus, layout=layout)
    with pytest.raises(brindle.Error, match="stiffness has no effect here"):
        torus.smooth_field(previous=brindle.Previous((torus, torus.smooth_field()), stiffness=0.1))


def test_rows_are_those_of_the_tool():
    names = {row["name"] for row in _core.option_rows()}
    assert {"solver", "epsilon", "winding", "fill", "stripes"} <= names
    row = brindle.advanced.option_rows()["cancel_distance"]
    assert row["words"] and row["range"][0] == 0 and row["slider"][1] > 1 and row["part_of"] == "cancel-branches"
