"""The public headers compile in programs without exceptions and type information.

$BRINDLE_COMPILER compiles them all but those that need MPI; $BRINDLE_EIGEN is the folder of Eigen's headers. A word of
the language that such programs do not have is an error wherever it stands.
"""

import os
import re
import subprocess

from conftest import ROOT

FLAGS = ["-std=c++20", "-fsyntax-only", "-fno-exceptions", "-fno-rtti", "-x", "c++", "-"]


def test_headers_compile():
    headers = sorted((ROOT / "include/brindle").glob("*.h"))
    taken = [h for h in headers if not re.search('<mpi.h>|"brindle/distributed_', h.read_text())]
    assert len(taken) >= 50
    result = subprocess.run(
        [os.environ["BRINDLE_COMPILER"], f"-I{ROOT / 'include'}", "-isystem", os.environ["BRINDLE_EIGEN"], *FLAGS],
        input="".join(f'#include "brindle/{h.name}"\n' for h in taken), capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
