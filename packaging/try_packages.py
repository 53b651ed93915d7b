#!/usr/bin/env python3
"""Installs packages in empty systems and draws the same picture with each; `./dev package` calls it.

usage: try_packages.py OUT [KIND...]

KIND: source, recipes, paraview, tarball, deb, wheel, npm; all of them unless given. A system is Debian
12 with drivers of OpenGL and numpy (mmdebstrap, which downloads it once), without any package that
building Brindle needs; OUT/system keeps it. Needs root, for mounts and chroot.
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
from make_packages import NAME, ROOT, filled

INCLUDED = "libegl1,libopengl0,libegl-mesa0,libgl1-mesa-dri,python3-venv,python3-numpy,ca-certificates"
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
CONSUMER = """
cmake_minimum_required(VERSION 3.25)
project(consumer CXX)
find_package(brindle @VERSION@ REQUIRED)
add_executable(picture @SOURCE@/docs/examples/picture.cpp)
target_link_libraries(picture PRIVATE brindle::brindle)
"""


class System:
    """An empty system that is gone afterwards: an overlay over the base, and chroot."""

    def __init__(self, base):
        self.base = base

    def __enter__(self):
        self.scratch = pathlib.Path(tempfile.mkdtemp())
        for name in ("upper", "work", "root"):
            (self.scratch / name).mkdir()
        self.root = self.scratch / "root"
        layers = f"lowerdir={self.base},upperdir={self.scratch}/upper,workdir={self.scratch}/work"
        subprocess.run(["mount", "-t", "overlay", "overlay", "-o", layers, self.root], check=True)
        subprocess.run(["mount", "-t", "proc", "proc", self.root / "proc"], check=True)
        shutil.copy("/etc/resolv.conf", self.root / "etc/resolv.conf")
        return self

    def __exit__(self, *_):
        subprocess.run(["umount", self.root / "proc"], check=True)
        subprocess.run(["umount", self.root], check=True)
        shutil.rmtree(self.scratch)

    def run(self, command, **environment):
        """Seconds that the shell command takes; its output is shown if it fails."""
        start = time.monotonic()
        done = subprocess.run(["chroot", self.root, "/bin/sh", "-ec", command], text=True, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "LC_ALL": "C.UTF-8",
                                   "DEBIAN_FRONTEND": "noninteractive", **environment})
        if done.returncode:
            raise SystemExit(f"failed in the empty system: {command}\n{done.stdout[-4000:]}")
        return time.monotonic() - start

    def copy(self, *files):
        for file in files:
            shutil.copy(file, self.root / "root")


def base_system(out, suite="bookworm", included=INCLUDED):
    base = out / "system" / suite
    if not base.exists():
        base.parent.mkdir(exist_ok=True)
        part = base.with_suffix(".part")
        shutil.rmtree(part, ignore_errors=True)
        subprocess.run(["mmdebstrap", "--quiet", "--variant=minbase", f"--include={included}", suite, part], check=True)
        part.rename(base)
    return base


def report(kind, file, installed, drawn, what):
    size = f"{file.stat().st_size / 1e6:.1f} MB"
    print(f"{kind:12} {size:>9}  installed in {installed:5.1f} s, {what} in {drawn:5.1f} s", flush=True)


def same_picture(pictures, kind, system):
    """All packages draw the same bits."""
    pictures[kind] = (system.root / "tmp/stripes.png").read_bytes()
    (OUT / f"pictures/{kind}.png").write_bytes(pictures[kind])
    if len(pictures[kind]) < 20000 or len(set(pictures.values())) > 1:
        raise SystemExit(f"pictures differ, see {OUT}/pictures")


def build_consumer(prefix, system):
    """Compiles the documentation's program here, where there is a compiler, against a package there."""
    with tempfile.TemporaryDirectory() as folder:
        version = NAME.rpartition("-")[2]
        pathlib.Path(folder, "CMakeLists.txt").write_text(filled(CONSUMER, {"SOURCE": str(ROOT), "VERSION": version}))
        subprocess.run(["cmake", "-S", folder, "-B", f"{folder}/build", f"-DCMAKE_PREFIX_PATH={prefix}",
                        "-DCMAKE_SKIP_RPATH=ON"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["cmake", "--build", f"{folder}/build"], check=True, stdout=subprocess.DEVNULL)
        system.copy(f"{folder}/build/picture")


def loaded_from(system, folder):
    """Fails unless every library is the package's or the system's."""
    for elf in elfs(system.root / folder):
        listing = subprocess.run(["chroot", system.root, "ldd", "/" + str(elf.relative_to(system.root))],
                                 capture_output=True, text=True).stdout
        if "not found" in listing:
            raise SystemExit(f"{elf.name} misses libraries:\n{listing}")
        for name, path in re.findall(r"(\S+) => (/\S+)", listing):
            if not OF_THE_SYSTEM.match(name) and not path.startswith(f"/{folder}"):
                raise SystemExit(f"{elf.name} takes {name} from {path}")


def fails_without(system, name, library):
    """Drivers are found at run time; the error names the library and the remedy."""
    without = f"cd /usr/lib/*-linux-gnu; mv {library} away; /opt/moved/bin/brindle {COMMAND}; mv away {library}"
    said = subprocess.run(["chroot", system.root, "/bin/sh", "-c", without], capture_output=True, text=True).stderr
    if f"there is no {name} on this system; install" not in said:
        raise SystemExit(f"without {library}, the tool says: {said}")


def try_tarball(pictures, base=None, kind="tarball"):
    file = OUT / f"{NAME}-Linux-x86_64.tar.gz"
    with System(base or base_system(OUT)) as system:
        system.copy(file)
        installed = system.run(f"mkdir /opt/moved && tar -xzf /root/{file.name} --strip-components=1 -C /opt/moved")
        loaded_from(system, "opt/moved")
        drawn = system.run(f"/opt/moved/bin/brindle {COMMAND}")
        if kind == "tarball":  # Another system's drivers may round otherwise.
            same_picture(pictures, kind, system)
        report(kind, file, installed, drawn, "picture")
        system.run("/opt/moved/bin/brindle stripe shape:torus --output /tmp/a.pdf && grep -q %%EOF /tmp/a.pdf")
        fails_without(system, "OpenGL", "libOpenGL.so.0")
        fails_without(system, "EGL", "libEGL.so.1")
        build_consumer(system.root / "opt/moved", system)
        system.run("LD_LIBRARY_PATH=/opt/moved/lib /root/picture /tmp/program.png && test -s /tmp/program.png")
    if kind == "tarball":
        try_ubuntu(pictures)


def try_deb(pictures):
    with System(base_system(OUT)) as system:
        files = sorted(OUT.glob("*.deb"))
        system.copy(*files)
        system.run("apt-get update -qq")
        installed = system.run("apt-get install -qq -y --no-install-recommends /root/*.deb")
        drawn = system.run(f"brindle {COMMAND}")
        same_picture(pictures, "deb", system)
        for file in files:
            report(file.name.partition("_")[0], file, installed, drawn, "(all together) picture")
        (system.root / "root/draw.py").write_text(PROGRAM)
        system.run("python3 /root/draw.py")
        same_picture(pictures, "deb-python3", system)
        build_consumer(system.root / "usr", system)
        system.run("/root/picture /tmp/program.png && test -s /tmp/program.png")
        system.run("apt-get purge -qq -y '*brindle*' && ! ls /usr/bin/brindle")


def try_wheel(pictures):
    file = next(OUT.glob("*.whl"))
    with System(base_system(OUT)) as system:
        system.copy(file)
        (system.root / "root/draw.py").write_text(PROGRAM)
        system.run("python3 -m venv --system-site-packages /opt/venv")
        installed = system.run(f"/opt/venv/bin/pip install --quiet --no-index /root/{file.name}")
        site = next((system.root / "opt/venv/lib").glob("python3*")).name
        loaded_from(system, f"opt/venv/lib/{site}/site-packages")
        system.run("/opt/venv/bin/pip check")
        drawn = system.run("/opt/venv/bin/python /root/draw.py")
        same_picture(pictures, "wheel", system)
        report("wheel", file, installed, drawn, "picture")


def try_npm(_):
    file = OUT / f"{NAME}-npm.tgz"
    with System(base_system(OUT)) as system:
        node = pathlib.Path(shutil.which("node")).resolve()
        home = system.root / "opt/node"
        home.mkdir()
        for path in [str(node), *(p for n, p in libraries_of(node).items() if not OF_THE_SYSTEM.match(n))]:
            shutil.copy(path, home)
        project = system.root / "root"
        start = time.monotonic()
        subprocess.run(["npm", "install", "--silent", "--offline", "--no-audit", file], cwd=project, check=True)
        installed = time.monotonic() - start
        (project / "draw.mjs").write_text(IN_NODE)
        system.run("test -s /root/node_modules/brindle/README.md")
        drawn = system.run("/opt/node/node --experimental-global-webcrypto /root/draw.mjs",
                           LD_LIBRARY_PATH="/opt/node")
        system.run("grep -c '<path' /tmp/stripes.svg")
        shutil.copy(system.root / "tmp/stripes.svg", OUT / "pictures/npm.svg")
        report("npm", file, installed, drawn, "drawing")


def try_source(_):
    """Conmetrics without network and builds the core."""
    file = OUT / f"{NAME}.tar.gz"
    with tempfile.TemporaryDirectory() as folder:
        start = time.monotonic()
        subprocess.run(["tar", "-xzf", file, "-C", folder], check=True)
        options = [f"-DBRINDLE_{name}=OFF" for name in "APPS TESTS GL VTK TBB HIGHWAY NANOFLANN".split()]
        quick = ["-GNinja", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_CXX_FLAGS_RELEASE=-O0"]
        for command in (["-S", f"{folder}/{NAME}", "-B", f"{folder}/build", *options, *quick],
                        ["--build", f"{folder}/build"]):
            subprocess.run(["unshare", "--net", "cmake", *command], check=True, stdout=subprocess.DEVNULL)
        print(f"{'source':12} {file.stat().st_size / 1e6:6.1f} MB  core built without network in "
              f"{time.monotonic() - start:.1f} s")


def try_paraview(_):
    """In this machine's ParaView; an empty system with ParaView would be a thousand packages."""
    file = next(OUT.glob("*ParaView*.tar.gz"))
    with tempfile.TemporaryDirectory() as folder:
        start = time.monotonic()
        subprocess.run(["tar", "-xzf", file, "-C", folder], check=True)
        installed = time.monotonic() - start
        plugin = next(pathlib.Path(folder).rglob("Brindle.so"))
        script = pathlib.Path(folder, "load.py")
        script.write_text(IN_PARAVIEW.format(plugin=plugin))
        start = time.monotonic()
        if "phase" not in subprocess.run(["pvpython", script], check=True, capture_output=True, text=True).stdout:
            raise SystemExit("the plugin makes no phases")
        report("paraview", file, installed, time.monotonic() - start, "stripes")


def try_recipes(_):
    """Syntax alone: none of them can run here."""
    import yaml
    for path in sorted((OUT / "recipes").rglob("*.json")):
        json.loads(path.read_text())
    shells = 0
    for path in [*sorted((OUT / "recipes").rglob("*.yaml")), *sorted((ROOT / ".github/workflows").glob("*.yml"))]:
        for step in scripts_of(yaml.safe_load(path.read_text())):
            subprocess.run(["bash", "-n"], input=re.sub(r"\$\{\{.*?\}\}", "x", step), text=True, check=True)
            shells += 1
    with tempfile.NamedTemporaryFile("w", suffix=".cmake") as dry_run:
        functions = set(re.findall(r"(?m)^(vcpkg_\w+)\(", (OUT / "recipes/vcpkg/portfile.cmake").read_text()))
        dry_run.write("".join(f"function({name})\nendfunction()\n" for name in sorted(functions)) +
                      f'set(CURRENT_PACKAGES_DIR /none)\ninclude("{OUT}/recipes/vcpkg/portfile.cmake")\n')
        dry_run.flush()
        subprocess.run(["cmake", "-P", dry_run.name], check=True)
    print(f"recipes: syntax checked, {shells} shell steps; none has run")


def scripts_of(tree):
    if isinstance(tree, dict):
        for key, value in tree.items():
            if key in ("run", "script") and isinstance(value, str):
                yield value
            yield from scripts_of(value)
    elif isinstance(tree, list):
        for item in tree:
            yield from scripts_of(item)


def try_ubuntu(pictures):
    keys = "/usr/share/keyrings/ubuntu-archive-keyring.gpg"
    if not os.path.exists(keys):
        return print(f"ubuntu: skipped, there is no {keys} (Debian 12 has no package of it)")
    try_tarball(pictures, base_system(OUT, "noble", "libegl1,libopengl0,libegl-mesa0,libgl1-mesa-dri"), "ubuntu")


def main():
    if os.geteuid():
        raise SystemExit("mounts need root: sudo packaging/try_packages.py build/packages")
    tries = (try_source, try_recipes, try_paraview, try_tarball, try_deb, try_wheel, try_npm)
    kinds = {function.__name__.removeprefix("try_"): function for function in tries}
    needs = {"recipes": (), "paraview": ("pvpython",), "source": ("unshare",), "npm": ("mmdebstrap", "npm")}
    pictures = {}
    (OUT / "pictures").mkdir(exist_ok=True)
    for kind in sys.argv[2:] or kinds:
        if kind == "blender":
            print("blender: ./dev blender tries the add-on")
        elif missing := [tool for tool in needs.get(kind, ("mmdebstrap",)) if not shutil.which(tool)]:
            print(f"{kind}: skipped, there is no {missing[0]}")
        else:
            kinds[kind](pictures)


OUT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "build/packages").resolve()
if __name__ == "__main__":
    main()
