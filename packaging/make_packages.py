#!/usr/bin/env python3
"""Makes packages of a build in OUT, a folder for each kind; `./dev package` calls it.

usage: make_packages.py BUILD OUT KIND...

KIND: source, deb, tarball, wheel, blender (of the wheel), npm (of build/web), paraview (of build/paraview)
or recipes.
Environment: DEBFULLNAME and DEBEMAIL, the maintainer of Debian packages; BRINDLE_RELEASES, the URL of
the folder from which recipes download.
"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from email.utils import formatdate

from bundle import bundle, elfs, libraries_of, output

ROOT = pathlib.Path(__file__).resolve().parent.parent
ABOUT = json.loads((ROOT / "packaging/about.json").read_text())
VERSION = re.search(r'define BRINDLE_VERSION "([^"]+)"', (ROOT / "include/brindle/version.h").read_text()).group(1)
NAME = f"{ABOUT['name']}-{VERSION}"
# Packages of headers and archives, whose licences come along.
IN_LIBRARY = "libeigen3-dev libhwy-dev libnanoflann-dev nlohmann-json3-dev "
IN_TOOL = IN_LIBRARY + "libcairo2-dev libcli11-dev libimgui-dev"
IN_PYTHON = IN_LIBRARY + "pybind11-dev"


def run(*command, **options):
    subprocess.run(command, check=True, **options)


def fresh(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def pack(folder, out):
    """A .tar.gz that does not depend on time or user."""
    run("tar", "--sort=name", "--mtime=@0", "--owner=0", "--group=0", "--numeric-owner", "-I", "gzip -9n",
        "-cf", out / f"{folder.name}.tar.gz", "-C", folder.parent, folder.name)


def filled(text, values):
    """The text with every @KEY@ replaced."""
    values = {**{key.upper(): value for key, value in ABOUT.items()}, "VERSION": VERSION,
              "SOVERSION": VERSION.rpartition(".")[0], **values}
    return re.sub(r"@([A-Z_0-9]+)@", lambda match: values[match[1]], text)


def fill_folder(source, target, values):
    for path in filter(pathlib.Path.is_file, source.rglob("*")):
        copy = target / filled(str(path.relative_to(source)).removesuffix(".in"), values)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(filled(path.read_text(), values))
        copy.chmod(path.stat().st_mode)


def make_source(out, *_):
    if output("git", "-C", ROOT, "status", "--porcelain", "--untracked-files=no"):
        print("the source tarball leaves out changes that are not committed")
    file = fresh(out / "source") / f"{NAME}.tar.gz"
    run("git", "-C", ROOT, "archive", f"--output={file}", f"--prefix={NAME}/", "HEAD")
    return file


def make_deb(out, build, work):
    run("tar", "-xzf", make_source(out), "-C", work)
    name, mail = os.environ.get("DEBFULLNAME", ABOUT["authors"]), os.environ.get("DEBEMAIL", "brindle@example.org")
    license_text = "\n".join(f" {line}" if line else " ." for line in (ROOT / "LICENSE").read_text().splitlines())
    fill_folder(ROOT / "packaging/debian", work / NAME / "debian",
                {"MAINTAINER": f"{name} <{mail}>", "LICENSE_TEXT": license_text,
                 "DATE": formatdate(int(output("git", "-C", ROOT, "log", "-1", "--format=%ct")))})
    run("dpkg-buildpackage", "-us", "-uc", "-b", cwd=work / NAME,
        env={**os.environ, "BRINDLE_BUILD_FOLDER": str(build)})
    run("lintian", "--fail-on", "error", "--allow-root", next(work.glob("*.changes")))
    fresh(out / "deb")
    for package in work.glob("*.deb"):
        shutil.copy(package, out / "deb")


def make_tarball(out, build, work):
    folder = work / f"{NAME}-Linux-x86_64"
    run("cmake", "--install", build, "--prefix", folder, "--strip", stdout=subprocess.DEVNULL)
    bundle(folder, folder / "lib/brindle", folder / "share/doc/brindle/licenses", IN_TOOL)
    pack(folder, fresh(out / "tarball"))


def make_wheel(out, build, work):
    run("/usr/bin/python3", "-m", "build", "--wheel", "--no-isolation", "--outdir", work, ROOT,
        env={**os.environ, "BRINDLE_BUILD_FOLDER": str(build)}, stdout=subprocess.DEVNULL)
    run("/usr/bin/python3", "-m", "wheel", "unpack", "--dest", work, next(work.glob("*.whl")),
        stdout=subprocess.DEVNULL)
    info = next(work.glob("*/*.dist-info"))
    bundle(info.parent, info.parent / "brindle_stripes.libs", info / "licenses", IN_PYTHON)
    glibc = os.confstr("CS_GNU_LIBC_VERSION").removeprefix("glibc ").replace(".", "_")
    wheel = info / "WHEEL"
    wheel.write_text(wheel.read_text().replace("-linux_x86_64", f"-manylinux_{glibc}_x86_64"))
    run("/usr/bin/python3", "-m", "wheel", "pack", "--dest-dir", fresh(out / "wheel"), info.parent,
        stdout=subprocess.DEVNULL)


def make_blender(out, _, work):
    """The add-on, with the wheel unpacked inside: before 4.2, Blender installs no wheels."""
    folder = work / "brindle_blender"
    fill_folder(ROOT / "blender/brindle_blender", folder, {"VERSION_TUPLE": VERSION.replace(".", ", ")})
    with zipfile.ZipFile(next((out / "wheel").glob("*.whl"))) as wheel:
        wheel.extractall(folder / "modules")
    name = f"{NAME}-blender-Linux-x86_64.zip"
    with zipfile.ZipFile(fresh(out / "blender") / name, "w", zipfile.ZIP_DEFLATED) as file:
        for path in sorted(path for path in folder.rglob("*") if path.is_file()):
            # Without times, which would change from run to run.
            entry = zipfile.ZipInfo(str(path.relative_to(folder.parent)))
            file.writestr(entry, path.read_bytes(), zipfile.ZIP_DEFLATED)


def make_npm(out, *_):
    run("npm", "pack", "--silent", "--pack-destination", fresh(out / "npm"), ROOT / "build/web/package")


def make_paraview(out, _, work):
    version = output("pvserver", "--version").split()[-1]
    folder = work / f"{NAME}-ParaView-{version}-Linux-x86_64"
    run("cmake", "--install", ROOT / "build/paraview/plugin", "--prefix", folder, "--strip", stdout=subprocess.DEVNULL)
    programs = [path for name in ("paraview", "pvserver") if (path := shutil.which(name))]
    given = {name for program in programs for name in libraries_of(program)} | {"libmpi.so.40"}
    given |= {name for elf in elfs(folder) for name in libraries_of(elf) if re.match(r"lib(vtk|Qt|python)", name)}
    bundle(folder, folder / "lib/brindle", folder / "licenses", IN_LIBRARY, given)
    shutil.copy(ROOT / "LICENSE", folder)
    # ParaView loads the plugin; programs cannot link it.
    shutil.rmtree(folder / "include")
    for archive in folder.rglob("*.a"):
        archive.unlink()
    pack(folder, fresh(out / "paraview"))


def make_recipes(out, *_):
    source = make_source(out)
    place, data = os.environ.get("BRINDLE_RELEASES", source.parent.as_uri()), source.read_bytes()
    fill_folder(ROOT / "packaging/recipes", fresh(out / "recipes"),
                {"URL": f"{place}/{source.name}", "SHA256": hashlib.sha256(data).hexdigest(),
                 "SHA512": hashlib.sha512(data).hexdigest()})


def main():
    build, out = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    for kind in sys.argv[3:]:
        print(f"package: {kind}", flush=True)
        with tempfile.TemporaryDirectory() as work:
            globals()[f"make_{kind}"](out, build, pathlib.Path(work))


if __name__ == "__main__":
    main()
