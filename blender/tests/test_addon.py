"""Runs checks in Blender, with the add-on installed from its zip; see BRINDLE_ADDON in ./dev blender."""
import ast
import os
import pathlib
import shutil
import subprocess

import pytest

HERE = pathlib.Path(__file__).resolve().parent
ADDON = pathlib.Path(os.environ.get("BRINDLE_ADDON", "none"))
PICTURES = HERE.parents[1] / "build/blender/pictures"

pytestmark = pytest.mark.skipif(not ADDON.is_file() or not shutil.which("blender"),
                                reason="./dev blender makes the add-on's zip and installs Blender")


def checks_of(file):
    return [item.name for item in ast.parse((HERE / file).read_text()).body
            if isinstance(item, ast.FunctionDef) and item.name.startswith("check_")]


def run(home, *words, under=()):
    """Blender with preferences of its own; its output is shown if it fails."""
    PICTURES.mkdir(parents=True, exist_ok=True)
    done = subprocess.run([*under, "blender", "--factory-startup", *words], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=900,
                          env={**os.environ, "BLENDER_USER_CONFIG": str(home / "config"),
                               "BLENDER_USER_SCRIPTS": str(home / "scripts"), "BRINDLE_PICTURES": str(PICTURES)})
    assert done.returncode == 0, done.stdout[-6000:]
    return done.stdout


@pytest.fixture(scope="session")
def home(tmp_path_factory):
    """A folder of preferences in which the add-on is installed as users install it."""
    home = tmp_path_factory.mktemp("blender")
    run(home, "--background", "--python-exit-code", "1", "--python-expr",
        f"import bpy; bpy.ops.preferences.addon_install(filepath={str(ADDON)!r})")
    assert (home / "scripts/addons/brindle_blender/modules/brindle").is_dir()
    return home


@pytest.mark.parametrize("name", checks_of("checks.py"))
def test_headless(home, name):
    run(home, "--background", "--python-exit-code", "1", "--python", HERE / "checks.py", "--", name)


def test_window(home):
    """Panels, undo and sliders, in a window."""
    printed = run(home, "--window-geometry", "0", "0", "1280", "900", "--python", HERE / "window.py",
                  "--", "--output", PICTURES / "window.jpg",
                  under=["xvfb-run", "-a", "-s", "-screen 0 1280x900x24 -noreset"])
    assert "window: all done" in printed
