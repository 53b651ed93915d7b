"""Puts the shared libraries that programs need beside them, as auditwheel does for wheels."""
import os
import pathlib
import re
import shutil
import subprocess

# Of the system that runs the package, because drivers of OpenGL are linked to its versions: the
# runtimes of C and C++, and X11 with what it needs.
OF_THE_SYSTEM = re.compile(r"(lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+|EGL|GL|GLX|OpenGL|X11|xcb|Xau|Xdmcp|bsd|md)\.so|"
                           r"ld-linux|linux-vdso)")


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def is_elf(path):
    if path.is_symlink() or not path.is_file():
        return False
    with open(path, "rb") as file:
        return file.read(4) == b"\x7fELF"


def elfs(folder):
    return [path for path in sorted(folder.rglob("*")) if is_elf(path)]


def libraries_of(elf):
    """{name: path} of the libraries that the loader finds, theirs included."""
    lines = output("ldd", elf)
    if missing := re.findall(r"(\S+) => not found", lines):
        raise SystemExit(f"{elf}: {', '.join(missing)} not found")
    return dict(re.findall(r"(\S+) => (/\S+)", lines))


def package_of(path):
    """The Debian package of a file."""
    for name in (path, path.removeprefix("/usr"), os.path.realpath(path)):
        found = subprocess.run(["dpkg", "-S", name], capture_output=True, text=True).stdout
        if found:
            return found.split(":")[0]
    raise SystemExit(f"{path}: no Debian package has it, so that its licence is not known")


def bundle(folder, libraries, licenses, linked_in, given=frozenset()):
    """Copies to `libraries` what files in `folder` need and neither the system nor `given` has, makes
    the files find it by relative paths, and copies the licences of it and of the packages `linked_in`."""
    programs = elfs(folder)
    needed = {name: path for program in programs for name, path in libraries_of(program).items()
              if not OF_THE_SYSTEM.match(name) and name not in given and not pathlib.Path(path).is_relative_to(folder)}
    libraries.mkdir(parents=True, exist_ok=True)
    for name, path in needed.items():
        shutil.copy(path, libraries / name)
    licenses.mkdir(parents=True, exist_ok=True)
    for package in {*linked_in.split(), *map(package_of, needed.values())}:
        shutil.copy(f"/usr/share/doc/{package}/copyright", licenses / f"{package}.txt")
    # The copies keep their names: patchelf 0.14 breaks symbol versions when it renames.
    for program in programs + [libraries / name for name in needed]:
        way = os.path.relpath(libraries, program.parent)
        output("patchelf", "--set-rpath", "$ORIGIN" if way == "." else f"$ORIGIN/{way}", program)
