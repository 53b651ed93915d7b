"""What these tests share: the programs that they try, and folders to work in."""

import os
import pathlib

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def pytest_addoption(parser):
    parser.addoption("--mesh", default="shape:torus,resolution=60", help="that other programs read")


@pytest.fixture(scope="session")
def tool():
    """The brindle program: $BRINDLE_TOOL, or that of the release build."""
    path = pathlib.Path(os.environ.get("BRINDLE_TOOL", ROOT / "build/release/apps/brindle/brindle")).resolve()
    assert path.is_file(), f"there is no program {path}"
    return str(path)
