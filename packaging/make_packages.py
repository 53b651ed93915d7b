#!/usr/bin/env python3
"""Makes packages of a build of the preset 'package'; `./dev package` calls it.

usage: make_packages.py BUILD OUT [KIND...]

KIND: source, deb, tarball, wheel, blender, npm, paraview, recipes; all of them unless given. Build
packages must be there; `npm` needs build/web, `paraview` needs build/paraview, `blender` the wheel.
"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import zipfile
from email.utils import formatdate

from bundle import bundle, elfs, glibc_of, libraries_of, output

ROOT = pathlib.Path(__file__).resolve().parent.parent
ABOUT = json.loads((ROOT / "packaging/about.json").read_text())
VERSION = re.search(r'define BRINDLE_VERSION "([^"]+)"', (ROOT / "include/brindle/version.h").read_text()).group(1)
NAME = f"{ABOUT['name']}-{VERSION}"
LIBRARIES = pathlib.Path("/usr/lib", output("gcc", "-print-multiarch").strip())
# Linked or compiled in, beside the shared libraries that bundle() finds.
LINKED_IN = ("libcli11-dev libeigen3-dev libhwy-dev libimgui-dev libnanoflann-dev nlohmann-json3-dev "
             "libcairo2-dev libpixman-1-dev libfontconfig-dev libexpat1-dev uuid-dev pybind11-dev")
# Cairo's shared library would bring X11's, which drivers of OpenGL need in the system's version.
# Of the archive, only the PDF writer is linked.
PDF_WRITER = [f"-Dpkgcfg_lib_CAIRO_cairo={LIBRARIES}/libcairo.a",
              "-DCMAKE_CXX_STANDARD_LIBRARIES=-l:libpixman-1.a -l:libfontconfig.a -l:libfreetype.a -l:libpng16.a "
              "-l:libexpat.a -l:libuuid.a -l:libbrotlidec.a -l:libbrotlicommon.a -l:libz.a -lm"]
SHARED_CAIRO = [f"-Dpkgcfg_lib_CAIRO_cairo={LIBRARIES}/libcairo.so", "-DCMAKE_CXX_STANDARD_LIBRARIES="]


def run(*command, **options):
    subprocess.run(command, check=True, **options)


def fresh(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def build(folder, *options):
    """Changes how a build links and installs; nothing is compiled again."""
    run("cmake", folder, "--log-level=WARNING", *options, stdout=subprocess.DEVNULL)
    run("cmake", "--build", folder, "--target", "brindle", "brindle_c", "brindle_tool", "brindle_python",
        stdout=subprocess.DEVNULL)


def pack(folder, out):
    """A .tar.gz that does not depend on time or user."""
    file = out / f"{folder.name}.tar.gz"
    run("tar", "--sort=name", "--mtime=@0", "--owner=0", "--group=0", "--numeric-owner", "-czf", file,
        "-C", folder.parent, folder.name, env={**os.environ, "GZIP": "-9n"}, stderr=subprocess.DEVNULL)
    return file


def add_licenses(licenses):
    licenses.mkdir(parents=True, exist_ok=True)
    shutil.copy(ROOT / "LICENSE", licenses / "brindle.txt")
    for package in LINKED_IN.split():
        shutil.copy(f"/usr/share/doc/{package}/copyright", licenses / f"{package}.txt")


def filled(text, more=None):
    """The text with every @KEY@ replaced."""
    values = {**{key.upper(): value for key, value in ABOUT.items()}, "VERSION": VERSION,
              "SOVERSION": VERSION.rpartition(".")[0], **(more or {})}
    return re.sub(r"@([A-Z_0-9]+)@", lambda match: values[match[1]], text)


def fill_folder(source, target, more=None):
    for path in sorted(source.rglob("*")):
        if path.is_file():
            copy = target / filled(str(path.relative_to(source)).removesuffix(".in"), more)
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(filled(path.read_text(), more))
            copy.chmod(path.stat().st_mode)


def make_source(_, out):
    if output("git", "-C", ROOT, "status", "--porcelain", "--untracked-files=no"):
        print("the source tarball leaves out changes that are not committed")
    with open(out / f"{NAME}.tar.gz", "wb") as file:
        run("git", "-C", ROOT, "archive", "--format=tar.gz", f"--prefix={NAME}/", "HEAD", stdout=file)


def make_deb(build_folder, out):
    """From the source tarball; BUILD saves compiling if it is there."""
    work = fresh(out / "work/deb")
    shutil.copy(out / f"{NAME}.tar.gz", work / f"{ABOUT['name']}_{VERSION}.orig.tar.gz")
    run("tar", "-xzf", out / f"{NAME}.tar.gz", "-C", work)
    tree = work / NAME
    name, mail = os.environ.get("DEBFULLNAME", ABOUT["authors"]), os.environ.get("DEBEMAIL", "brindle@example.org")
    date = formatdate(int(output("git", "-C", ROOT, "log", "-1", "--format=%ct")))
    license_text = "\n".join(f" {line}" if line else " ." for line in (ROOT / "LICENSE").read_text().splitlines())
    fill_folder(ROOT / "packaging/debian", tree / "debian",
                {"MAINTAINER": f"{name} <{mail}>", "DATE": date, "LICENSE_TEXT": license_text})
    environment = dict(os.environ)
    if build_folder.exists():
        environment["BRINDLE_BUILD_FOLDER"] = str(build_folder)
        build(build_folder, *SHARED_CAIRO)
    log = out / "work/deb.log"
    with open(log, "w") as file:
        status = subprocess.run(["dpkg-buildpackage", "-us", "-uc", "-j2"], cwd=tree, env=environment,
                                stdout=file, stderr=subprocess.STDOUT).returncode
    if status:
        raise SystemExit("".join(log.read_text().splitlines(keepends=True)[-40:]))
    for old in out.glob("*.deb"):
        old.unlink()
    for package in work.glob("*.deb"):
        shutil.copy(package, out)
    run("lintian", "--fail-on", "error", "--allow-root", next(work.glob("*.changes")))


def make_tarball(build_folder, out):
    folder = fresh(out / f"work/{NAME}-Linux-x86_64")
    build(build_folder, "-DCMAKE_INSTALL_LIBDIR=lib", *PDF_WRITER)
    run("cmake", "--install", build_folder, "--prefix", folder, "--strip", stdout=subprocess.DEVNULL)
    licenses = folder / "share/doc/brindle/licenses"
    bundle(folder, folder / "lib/brindle", licenses)
    add_licenses(licenses)
    print(f"needs glibc 2.{glibc_of(folder)}: {pack(folder, out)}")


def make_wheel(build_folder, out):
    work = fresh(out / "work/wheel")
    run("/usr/bin/python3", "-m", "build", "--wheel", "--no-isolation", "--outdir", work, ROOT,
        env={**os.environ, "BRINDLE_BUILD_FOLDER": str(build_folder)}, stdout=subprocess.DEVNULL)
    run("/usr/bin/python3", "-m", "wheel", "unpack", "--dest", work, next(work.glob("*.whl")),
        stdout=subprocess.DEVNULL)
    folder = next(path for path in work.iterdir() if path.is_dir())
    info = next(folder.glob("*.dist-info"))
    bundle(folder, folder / "brindle_stripes.libs", info / "licenses")
    add_licenses(info / "licenses")
    tags = re.sub(r"(?m)^(Tag: .*)-linux_x86_64$", rf"\1-manylinux_2_{glibc_of(folder)}_x86_64",
                  (info / "WHEEL").read_text())
    (info / "WHEEL").write_text(tags)
    for old in out.glob("*.whl"):
        old.unlink()
    run("/usr/bin/python3", "-m", "wheel", "pack", "--dest-dir", out, folder, stdout=subprocess.DEVNULL)


def make_blender(_, out):
    """The add-on, with the wheel unpacked inside: before 4.2, Blender installs no wheels."""
    folder = fresh(out / "work/blender/brindle_blender")
    fill_folder(ROOT / "blender/brindle_blender", folder, {"VERSION_TUPLE": VERSION.replace(".", ", ")})
    with zipfile.ZipFile(next(out.glob("*.whl"))) as wheel:
        wheel.extractall(folder / "modules")
    with zipfile.ZipFile(out / f"{NAME}-blender-Linux-x86_64.zip", "w", zipfile.ZIP_DEFLATED) as file:
        for path in sorted(path for path in folder.rglob("*") if path.is_file()):
            # Without times, which would change from run to run.
            entry = zipfile.ZipInfo(str(path.relative_to(folder.parent)))
            file.writestr(entry, path.read_bytes(), zipfile.ZIP_DEFLATED)


def make_npm(_, out):
    # npm names the file after name and version.
    run("npm", "pack", "--silent", "--pack-destination", out, ROOT / "build/web/package")
    (out / f"{NAME}.tgz").replace(out / f"{NAME}-npm.tgz")


def make_paraview(_, out):
    version = output("pvserver", "--version").split()[-1]
    folder = fresh(out / f"work/{NAME}-ParaView-{version}-Linux-x86_64")
    run("cmake", "--install", ROOT / "build/paraview/plugin", "--prefix", folder, "--strip", stdout=subprocess.DEVNULL)
    programs = [path for name in ("paraview", "pvserver") if (path := shutil.which(name))]
    given = {name for program in programs for name in libraries_of(program)} | {"libmpi.so.40"}
    given |= {name for elf in elfs(folder) for name in libraries_of(elf) if re.match(r"lib(vtk|Qt|python)", name)}
    bundle(folder, folder / "lib/brindle", folder / "licenses", given)
    add_licenses(folder / "licenses")
    # ParaView loads the plugin; programs cannot link it.
    shutil.rmtree(folder / "include")
    for archive in folder.rglob("*.a"):
        archive.unlink()
    pack(folder, out)


def make_recipes(_, out):
    source = out / f"{NAME}.tar.gz"
    place = os.environ.get("BRINDLE_RELEASES", f"file://{out}")
    data = source.read_bytes()
    fill_folder(ROOT / "packaging/recipes", fresh(out / "recipes"),
                {"URL": f"{place}/{source.name}", "SHA256": hashlib.sha256(data).hexdigest(),
                 "SHA512": hashlib.sha512(data).hexdigest()})


def main():
    build_folder, out = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    out.mkdir(parents=True, exist_ok=True)
    kinds = {"source": make_source, "deb": make_deb, "tarball": make_tarball, "wheel": make_wheel,
             "blender": make_blender, "npm": make_npm, "paraview": make_paraview, "recipes": make_recipes}
    for kind in sys.argv[3:] or kinds:
        print(f"package: {kind}", flush=True)
        kinds[kind](build_folder, out)


if __name__ == "__main__":
    main()
