"""What a program prints on this processor and on others, which QEMU acts as: $BRINDLE_FINGERPRINTS.

Skipped where there is no qemu-x86_64 (Debian and Ubuntu: qemu-user) or this processor is no x86-64.
"""

import os
import platform
import shutil
import subprocess

import pytest

# With SSE4, and with AVX2 and fused multiply-adds. AVX-512 QEMU does not know.
PROCESSORS = ("Nehalem", "Haswell")


def printed(command):
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    assert lines, f"{' '.join(command)} printed nothing"
    return lines


@pytest.mark.parametrize("processor", PROCESSORS)
def test_bits_are_the_same(processor):
    program = os.environ["BRINDLE_FINGERPRINTS"]
    qemu = shutil.which("qemu-x86_64")
    if platform.machine() != "x86_64" or not qemu:
        pytest.skip("no qemu-x86_64 (qemu-user), or no x86-64")
    assert printed([qemu, "-cpu", processor, program]) == printed([program])
