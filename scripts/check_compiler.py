#!/usr/bin/env python3
"""Whether the compiler of a build understands its sources: reads them, makes nothing.

usage: check_compiler.py BUILD [PREFIX ...]

BUILD has a compile_commands.json. With PREFIXes of its folders, such as src or apps/gallery, only what
is compiled there.
"""

import concurrent.futures
import json
import os
import pathlib
import shlex
import subprocess
import sys


def made_by(words):
    """Where the compiler would put what it makes."""
    return words[words.index("-o") + 1]


def understood(entry):
    words = shlex.split(entry["command"])
    at = words.index("-o")
    command = [*words[:at], *words[at + 2:], "-fsyntax-only"]
    done = subprocess.run(command, cwd=entry["directory"], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    return done.returncode == 0, done.stdout


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1])
    prefixes = tuple(sys.argv[2:]) or ("",)
    entries = [entry for entry in json.loads((build / "compile_commands.json").read_text())
               if made_by(shlex.split(entry["command"])).startswith(prefixes)]
    if not entries:
        sys.exit(f"{build}: nothing is compiled in {' '.join(prefixes)}")
    wrong = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for entry, (fine, output) in zip(entries, pool.map(understood, entries)):
            if not fine:
                wrong += 1
                print(f"{entry['file']}:\n{output}", file=sys.stderr)
    print(f"{len(entries)} sources read, {wrong} not understood")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
