#!/usr/bin/env python3
"""Installs packages in empty systems and draws the same picture with each; `./dev package` calls it.

usage: try_packages.py OUT KIND...

OUT and KIND are those of make_packages.py. An empty system is Debian 12 or Ubuntu 24.04 with drivers of
OpenGL and numpy, without any package that building Brindle needs; mmdebstrap downloads it once to
OUT/system. Needs root, for mounts and chroot.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

from bundle import OF_THE_SYSTEM, elfs, libraries_of
from make_packages import NAME, ROOT, fresh, run

INCLUDED = "libegl1,libopengl0,libegl-mesa0,libgl1-mesa-dri,python3-venv,python3-numpy,ca-certificates"
# Suites, and their addresses if they are not Debian's. Debian 12 has no keys of Ubuntu; HTTPS vouches for the server.
SYSTEMS = {"bookworm": [], "noble": ["deb [trusted=yes] https://archive.ubuntu.com/ubuntu noble main universe"]}
# As in README.
COMMAND = "stripe shape:trefoil --field curvature --size 640x450 --output /tmp/stripes.png"
PROGRAM = """
import brindle
s = brindle.shape("trefoil")
p = brindle.stripes(s, s.curvature_field("max"))
brindle.write_png("/tmp/stripes.png", brindle.render(s, p, size=(640, 450)))
"""
IN_NODE = """
import createBrindle from 'brindle';
import { writeFileSync } from 'node:fs';
const brindle = await createBrindle();
const surface = brindle.shape('trefoil');
const pattern = surface.stripes(surface.curvatureField(), { stripes: 40 });
writeFileSync('/tmp/stripes.svg', pattern.svg());
"""
IN_PARAVIEW = """
import paraview.simple as pv
pv.LoadPlugin('{plugin}', remote=False, ns=globals())
s = BrindleStripes(Input=pv.Sphere(ThetaResolution=60, PhiResolution=60), Stripes=12)
s.UpdatePipeline()
print(s.PointData.keys())
"""
# The documentation's programs, in C++ and C.
PROGRAMS = """
cmake_minimum_required(VERSION 3.25)
project(programs C CXX)
find_package(brindle REQUIRED)
add_executable(picture ${EXAMPLES}/picture.cpp)
target_link_libraries(picture PRIVATE brindle::brindle)
find_package(PkgConfig REQUIRED)
pkg_check_modules(C REQUIRED IMPORTED_TARGET brindle_c)
add_executable(stripes ${EXAMPLES}/stripes.c)
target_link_libraries(stripes PRIVATE PkgConfig::C)
"""


class System:
    """An empty system that is gone afterwards: an overlay over the base, and chroot."""

    def __init__(self, out, suite="bookworm"):
        self.base = out / "system" / suite
        if not self.base.exists():
            part = fresh(self.base.with_suffix(".part"))
            run("mmdebstrap", "--quiet", "--variant=minbase", f"--include={INCLUDED}", suite, part, *SYSTEMS[suite])
            part.rename(self.base)

    def __enter__(self):
        self.scratch = pathlib.Path(tempfile.mkdtemp())
        for name in ("upper", "work", "root"):
            (self.scratch / name).mkdir()
        self.root = self.scratch / "root"
        layers = f"lowerdir={self.base},upperdir={self.scratch}/upper,workdir={self.scratch}/work"
        run("mount", "-t", "overlay", "overlay", "-o", layers, self.root)
        run("mount", "-t", "proc", "proc", self.root / "proc")
        shutil.copy("/etc/resolv.conf", self.root / "etc/resolv.conf")
        return self

    def __exit__(self, *_):
        run("umount", self.root / "proc")
        run("umount", self.root)
        shutil.rmtree(self.scratch)

    def run(self, command, **environment):
        """Seconds that the shell command takes; its output is shown if it fails."""
        start = time.monotonic()
        done = self.start(command, **environment)
        if done.returncode:
            raise SystemExit(f"failed in the empty system: {command}\n{done.stdout[-4000:]}")
        return time.monotonic() - start

    def start(self, command, **environment):
        return subprocess.run(["chroot", self.root, "/bin/sh", "-ec", command], text=True, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "LC_ALL": "C.UTF-8",
                                   "DEBIAN_FRONTEND": "noninteractive", **environment})

    def copy(self, *files):
        for file in files:
            shutil.copy(file, self.root / "root")


def report(*files, **seconds):
    sizes = [f"{file.name} ({file.stat().st_size / 1e6:.1f} MB)" for file in files]
    print(", ".join(sizes + [f"{what} in {time:.1f} s" for what, time in seconds.items()]), flush=True)


def keep_picture(out, kind, system):
    """All packages draw the same bits."""
    picture = (system.root / "tmp/stripes.png").read_bytes()
    (out / f"pictures/{kind}.png").write_bytes(picture)
    if len({file.read_bytes() for file in (out / "pictures").glob("*.png")}) > 1 or len(picture) < 20000:
        raise SystemExit(f"pictures differ, see {out}/pictures")


def try_programs(prefix, libraries, system):
    """Compiles programs here, where there is a compiler, against a package in the system."""
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "CMakeLists.txt").write_text(PROGRAMS)
        run("cmake", "-S", folder, "-B", f"{folder}/build", f"-DCMAKE_PREFIX_PATH={system.root / prefix}",
            f"-DEXAMPLES={ROOT}/docs/examples", "-DCMAKE_SKIP_RPATH=ON", stdout=subprocess.DEVNULL)
        run("cmake", "--build", f"{folder}/build", stdout=subprocess.DEVNULL)
        system.copy(f"{folder}/build/picture", f"{folder}/build/stripes")
    system.run("/root/picture /tmp/program.png && test -s /tmp/program.png && /root/stripes",
               LD_LIBRARY_PATH=libraries)


def check_libraries(system, folder):
    """Fails unless every library is the package's or the system's."""
    for elf in elfs(system.root / folder):
        listing = system.start(f"ldd /{elf.relative_to(system.root)}").stdout
        if "not found" in listing:
            raise SystemExit(f"{elf.name} misses libraries:\n{listing}")
        for name, path in re.findall(r"(\S+) => (/\S+)", listing):
            if not OF_THE_SYSTEM.match(name) and not path.startswith(f"/{folder}"):
                raise SystemExit(f"{elf.name} takes {name} from {path}")


def fails_without(system, name, library):
    """Drivers are found at run time; the error names the library and the remedy."""
    said = system.start(f"cd /usr/lib/*-linux-gnu; mv {library} away; /opt/moved/bin/brindle {COMMAND} || "
                        f"mv away {library}").stdout
    if f"there is no {name} on this system; install" not in said:
        raise SystemExit(f"without {library}, the tool says: {said}")


def try_source(out):
    """Builds the core without network."""
    file = out / f"source/{NAME}.tar.gz"
    with tempfile.TemporaryDirectory() as folder:
        start = time.monotonic()
        run("tar", "-xzf", file, "-C", folder)
        options = [f"-DBRINDLE_{name}=OFF" for name in "APPS TESTS GL VTK TBB HIGHWAY NANOFLANN".split()]
        run("unshare", "--net", "cmake", "-S", f"{folder}/{NAME}", "-B", f"{folder}/build", *options, "-GNinja",
            "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_CXX_FLAGS_RELEASE=-O0", stdout=subprocess.DEVNULL)
        run("unshare", "--net", "cmake", "--build", f"{folder}/build", stdout=subprocess.DEVNULL)
        report(file, built=time.monotonic() - start)


def try_deb(out):
    with System(out) as system:
        files = sorted((out / "deb").glob("*.deb"))
        system.copy(*files)
        system.run("apt-get update -qq")
        installed = system.run("apt-get install -qq -y --no-install-recommends /root/*.deb")
        drawn = system.run(f"brindle {COMMAND}")
        keep_picture(out, "deb", system)
        report(*files, installed=installed, drawn=drawn)
        (system.root / "root/draw.py").write_text(PROGRAM)
        system.run("python3 /root/draw.py")
        keep_picture(out, "deb-python3", system)
        try_programs("usr", "", system)
        system.run("apt-get purge -qq -y '*brindle*' && ! ls /usr/bin/brindle")


def try_tarball(out):
    file = next((out / "tarball").iterdir())
    for suite in SYSTEMS:
        with System(out, suite) as system:
            system.copy(file)
            installed = system.run(f"mkdir /opt/moved && tar -xzf /root/{file.name} --strip-components=1 -C /opt/moved")
            check_libraries(system, "opt/moved")
            drawn = system.run(f"/opt/moved/bin/brindle {COMMAND}")
            if suite == "bookworm":  # Another system's drivers may round otherwise.
                keep_picture(out, "tarball", system)
            print(f"{suite}: ", end="")
            report(file, installed=installed, drawn=drawn)
            system.run("/opt/moved/bin/brindle stripe shape:torus --output /tmp/a.pdf && grep -q %%EOF /tmp/a.pdf")
            fails_without(system, "OpenGL", "libOpenGL.so.0")
            fails_without(system, "EGL", "libEGL.so.1")
            try_programs("opt/moved", "/opt/moved/lib:/opt/moved/lib/brindle", system)


def try_wheel(out):
    file = next((out / "wheel").iterdir())
    with System(out) as system:
        system.copy(file)
        (system.root / "root/draw.py").write_text(PROGRAM)
        system.run("python3 -m venv --system-site-packages /opt/venv")
        installed = system.run(f"/opt/venv/bin/pip install --quiet --no-index /root/{file.name}")
        check_libraries(system, "opt/venv/lib")
        system.run("/opt/venv/bin/pip check")
        drawn = system.run("/opt/venv/bin/python /root/draw.py")
        keep_picture(out, "wheel", system)
        report(file, installed=installed, drawn=drawn)


def try_npm(out):
    file = next((out / "npm").iterdir())
    with System(out) as system:
        node = pathlib.Path(shutil.which("node")).resolve()
        home = system.root / "opt/node"
        home.mkdir()
        for path in [node, *(path for name, path in libraries_of(node).items() if not OF_THE_SYSTEM.match(name))]:
            shutil.copy(path, home)
        start = time.monotonic()
        run("npm", "install", "--silent", "--offline", "--no-audit", file, cwd=system.root / "root")
        installed = time.monotonic() - start
        (system.root / "root/draw.mjs").write_text(IN_NODE)
        system.run("test -s /root/node_modules/brindle/README.md")
        # Debian 12's node 18 has random numbers only if it is told so.
        drawn = system.run("/opt/node/node --experimental-global-webcrypto /root/draw.mjs",
                           LD_LIBRARY_PATH="/opt/node")
        system.run("grep -c '<path' /tmp/stripes.svg")
        shutil.copy(system.root / "tmp/stripes.svg", out / "pictures/npm.svg")
        report(file, installed=installed, drawn=drawn)


def try_paraview(out):
    """In this machine's ParaView; an empty system with ParaView would be a thousand packages."""
    file = next((out / "paraview").iterdir())
    with tempfile.TemporaryDirectory() as folder:
        start = time.monotonic()
        run("tar", "-xzf", file, "-C", folder)
        installed = time.monotonic() - start
        script = pathlib.Path(folder, "load.py")
        script.write_text(IN_PARAVIEW.format(plugin=next(pathlib.Path(folder).rglob("Brindle.so"))))
        start = time.monotonic()
        if "phase" not in subprocess.run(["pvpython", script], check=True, capture_output=True, text=True).stdout:
            raise SystemExit("the plugin makes no phases")
        report(file, installed=installed, striped=time.monotonic() - start)


def try_recipes(out):
    """Syntax alone: none of them can run here."""
    import yaml
    json.loads((out / "recipes/vcpkg/vcpkg.json").read_text())
    conda = yaml.safe_load((out / "recipes/conda/meta.yaml").read_text())
    github = yaml.safe_load((ROOT / ".github/workflows/packages.yml").read_text())
    steps = [step["run"] for job in github["jobs"].values() for step in job["steps"] if "run" in step]
    for step in [conda["build"]["script"], *steps]:
        run("bash", "-n", input=re.sub(r"\$\{\{.*?\}\}", "x", step), text=True)
    portfile = out / "recipes/vcpkg/portfile.cmake"
    with tempfile.NamedTemporaryFile("w", suffix=".cmake") as dry_run:
        functions = set(re.findall(r"(?m)^vcpkg_\w+", portfile.read_text()))
        dry_run.write("".join(f"function({name})\nendfunction()\n" for name in functions) +
                      f'set(CURRENT_PACKAGES_DIR /none)\ninclude("{portfile}")\n')
        dry_run.flush()
        run("cmake", "-P", dry_run.name)
    print("recipes: only their syntax is checked")


def main():
    if os.geteuid():
        raise SystemExit("mounts need root: sudo packaging/try_packages.py build/packages KIND...")
    out = pathlib.Path(sys.argv[1]).resolve()
    fresh(out / "pictures")
    for kind in sys.argv[2:]:
        globals()[f"try_{kind}"](out)


if __name__ == "__main__":
    main()
