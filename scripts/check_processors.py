#!/usr/bin/env python3
"""Compares what a program prints on this processor and on others, which QEMU acts as.

usage: check_processors.py PROGRAM

Exits with 0 if all print the same, 1 if not, and 77 where there is no qemu-x86_64 (Debian and Ubuntu:
qemu-user) or this processor is no x86-64.
"""

import concurrent.futures
import platform
import shutil
import subprocess
import sys

# With SSE4, and with AVX2 and fused multiply-adds. AVX-512 QEMU does not know.
PROCESSORS = ("Nehalem", "Haswell")


def printed(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit {done.returncode}\n{done.stderr}")
    lines = done.stdout.splitlines()
    if not lines:
        sys.exit(f"{' '.join(command)} printed nothing")
    return lines


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    program = sys.argv[1]
    qemu = shutil.which("qemu-x86_64")
    if platform.machine() != "x86_64" or not qemu:
        print("skipped: no qemu-x86_64 (qemu-user), or no x86-64", file=sys.stderr)
        return 77
    here = printed([program])
    differ = False
    with concurrent.futures.ThreadPoolExecutor() as pool:
        results = pool.map(lambda p: printed([qemu, "-cpu", p, program]), PROCESSORS)
    for processor, there in zip(PROCESSORS, results):
        wrong = [(a, b) for a, b in zip(here, there) if a != b]
        print(f"{processor:<8} {len(there)} lines, {len(wrong)} differ")
        for a, b in wrong:
            print(f"  here  {a}\n  there {b}")
        differ = differ or bool(wrong) or len(here) != len(there)
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
