#!/usr/bin/env python3
"""Compiles the public headers as programs without exceptions and type information do.

usage: check_headers.py COMPILER INCLUDE [INCLUDE...]

INCLUDE are folders of headers, the first with brindle/, all of whose headers are compiled but those that
need MPI. A word of the language that such programs do not have is an error wherever it stands.
"""
import pathlib
import re
import subprocess
import sys

FLAGS = ['-std=c++20', '-fsyntax-only', '-fno-exceptions', '-fno-rtti', '-x', 'c++', '-']


def compile_text(compiler, folders, text):
    words = [compiler, f'-I{folders[0]}']
    for folder in folders[1:]:
        words += ['-isystem', folder]
    return subprocess.run(words + FLAGS, input=text, capture_output=True, text=True)


def main(arguments):
    compiler, *folders = arguments
    headers = sorted(pathlib.Path(folders[0], 'brindle').glob('*.h'))
    taken = [h for h in headers if not re.search('<mpi.h>|"brindle/distributed_', h.read_text())]
    if len(taken) < 50:
        print(f'there are only {len(taken)} headers in {folders[0]}/brindle', file=sys.stderr)
        return 1
    result = compile_text(compiler, folders, ''.join(f'#include "brindle/{h.name}"\n' for h in taken))
    print(result.stderr, file=sys.stderr, end='')
    return result.returncode


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
