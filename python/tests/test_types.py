"""Types as a type checker sees them, in the package and in a program that uses it."""
import pathlib
import subprocess
import sys

import brindle
import pytest

pytest.importorskip("mypy")

PROGRAM = """
import brindle
s = brindle.read("mesh.obj")
p = brindle.stripes(s, s.smooth_field(), stripes=40, solver="multilevel")
p.write("a.vtp")
length: float = p.curves(fair=0.25).lengths.sum()
u: brindle.Stripes = brindle.texture(s).u
"""


def checked(tmp_path, *words):
    folder = str(pathlib.Path(brindle.__file__).parents[1])
    done = subprocess.run([sys.executable, "-m", "mypy", "--ignore-missing-imports",
                           f"--cache-dir={tmp_path}", *words],
                          capture_output=True, text=True, env={"MYPYPATH": folder, "PATH": "/usr/bin"})
    return done.stdout + done.stderr


def test_the_package_agrees_with_its_own_types(tmp_path):
    assert "Success" in checked(tmp_path, "-p", "brindle")


def test_programs_are_told_of_wrong_words(tmp_path):
    program = tmp_path / "program.py"
    program.write_text(PROGRAM)
    assert "Success" in checked(tmp_path, str(program))
    program.write_text(PROGRAM.replace('"multilevel"', '"multigrid"'))
    assert 'Argument "solver" to "stripes"' in checked(tmp_path, str(program))
