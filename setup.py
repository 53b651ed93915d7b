"""Lets CMake build the package's module. Its version is that of include/brindle/version.h, its
description that of packaging/about.json.

Environment: CMAKE_ARGS, more for CMake ("-DBRINDLE_CHOLMOD=ON"); BRINDLE_BUILD_FOLDER, a build
folder that is there and used as it is configured ("build/release"), so that nothing is built twice.
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


def version():
    text = (ROOT / "include/brindle/version.h").read_text()
    return re.search(r'define BRINDLE_VERSION "([^"]+)"', text).group(1)


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        target = pathlib.Path(self.get_ext_fullpath(extension.name)).resolve().parent
        given = os.environ.get("BRINDLE_BUILD_FOLDER")
        folder = ROOT / given if given else ROOT / "build" / "python"
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, *self.configuration(bool(given))],
                       check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["cmake", "--build", folder, "--target", "brindle_python",
                        "--parallel", str(os.cpu_count() or 1)], check=True)
        subprocess.run(["cmake", "--install", folder, "--component", "python",
                        "--prefix", target.parent], check=True, stdout=subprocess.DEVNULL)

    @staticmethod
    def configuration(given):
        options = ["-DBRINDLE_PYTHON=ON"]
        if not given:
            import pybind11

            options += [f"-DPython_EXECUTABLE={sys.executable}",
                        f"-Dpybind11_DIR={pybind11.get_cmake_dir()}",
                        "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON",
                        "-DBRINDLE_APPS=OFF", "-DBRINDLE_TESTS=OFF"]
            if shutil.which("ninja"):
                options.append("-GNinja")
        return options + shlex.split(os.environ.get("CMAKE_ARGS", ""))


about = json.loads((ROOT / "packaging/about.json").read_text())
setup(version=version(), description=about["description"], license=about["license"],
      ext_modules=[Extension("brindle._core", [])], cmdclass={"build_ext": BuildByCMake},
      options={"build": {"build_base": "build/setuptools"},
               "egg_info": {"egg_base": "python"}})
