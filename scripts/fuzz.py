#!/usr/bin/python3
"""Lets libFuzzer look for inputs that break what Brindle promises, in all targets or one.

    scripts/fuzz.py build/fuzz/fuzz [TARGET|all] [SECONDS]

SECONDS (60) are shared among the targets, as many of which run at once as there are processors. What was
learned stays in build/fuzz/corpus, where the next run goes on, how often each target ran in executions.json beside
it; what was found is kept in build/fuzz/finds. Prints a table. Exits with 0 if all promises were kept, 1 if one was broken, 2 on wrong usage, 130 where
Ctrl-C ended it.
"""

import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parent.parent
# A pattern takes milliseconds under the sanitizers, a file far less; ten seconds are a hang.
LIMITS = ("-timeout=10", "-rss_limit_mb=3000", "-malloc_limit_mb=1024", "-max_len=8192",
          "-print_final_stats=1")
# What libFuzzer ends with where it is interrupted; it says what it did until then.
INTERRUPTED = 72
running = set()
stopped = threading.Event()


def usage(why):
    print(f"fuzz: {why}\n{__doc__.split(chr(10) * 2)[1]}", file=sys.stderr)
    sys.exit(2)


def last(pattern, text):
    found = re.findall(pattern, text)
    return int(found[-1]) if found else 0


def fuzz(binaries, target, seconds):
    """One target for so long: its row of the table and what was said."""
    row = run(binaries, target, seconds)
    while row["code"] != 0 and was_held_up(binaries, target, row) and not stopped.is_set():
        left = seconds - row["seconds"]
        row["code"] = 0
        if left < 1:
            break
        more = run(binaries, target, left)
        more["executions"] += row["executions"]
        more["seconds"] += row["seconds"]
        row = more
    return row


def run(binaries, target, seconds):
    """libFuzzer, until the time is over or it finds something."""
    corpus, finds = (binaries.parent / kind / target for kind in ("corpus", "finds"))
    known = ROOT / "fuzz" / "finds" / target
    for folder in (corpus, finds):
        folder.mkdir(parents=True, exist_ok=True)
    folders = [corpus, binaries.parent / "seeds" / target] + ([known] if known.is_dir() else [])
    words = [binaries / "fuzzer", *folders, f"-max_total_time={max(1, round(seconds))}",
             f"-artifact_prefix={finds}/", f"-dict={dictionary(binaries, target)}", *LIMITS]
    began = time.monotonic()
    code, said = output_of(words, target)
    return {"target": target, "code": 0 if code == INTERRUPTED else code, "said": said,
            "executions": last(r"number_of_executed_units: (\d+)", said),
            "seconds": time.monotonic() - began,
            "covered": last(r"cov: (\d+)", said), "inputs": last(r"corp: (\d+)", said),
            "edges": last(r"Loaded \d+ modules? +\((\d+)", said),
            "slowest": last(r"slowest_unit_time_sec: (\d+)", said)}


def output_of(words, target):
    """What a fuzzer ends with, and what it says."""
    environment = {**os.environ, "BRINDLE_FUZZ_TARGET": target, "LP_NUM_THREADS": "0",
                   "ASAN_OPTIONS": "allocator_may_return_null=1:detect_leaks=1",
                   "LSAN_OPTIONS": f"suppressions={ROOT}/tests/lsan.supp:print_suppressions=0",
                   "UBSAN_OPTIONS": "print_stacktrace=1"}
    if stopped.is_set():
        return INTERRUPTED, ""
    process = subprocess.Popen([str(word) for word in words], env=environment, text=True,
                               errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               start_new_session=True)
    running.add(process)
    said, _ = process.communicate()
    running.discard(process)
    return process.returncode, said


def was_held_up(binaries, target, row):
    """Whether all that was found is an input that took too long, and does not when it runs again:
    then others had the processor."""
    found = re.findall(r"Test unit written to (\S+)", row["said"])
    late = ("timeout-", "slow-unit-")
    if not found or not all(pathlib.Path(path).name.startswith(late) for path in found):
        return False
    if any(output_of([binaries / "fuzzer", path, *LIMITS], target)[0] != 0 for path in found):
        return False
    for path in found:
        pathlib.Path(path).unlink()
    return True


def dictionary(binaries, target):
    """The words of a target's seeds, which libFuzzer puts together anew."""
    words = set()
    for seed in (binaries.parent / "seeds" / target).iterdir():
        words.update(re.findall(rb"[A-Za-z_][A-Za-z_0-9]{2,30}", seed.read_bytes()))
    path = binaries.parent / "seeds" / f"{target}.dict"
    path.write_text("".join(f'"{word.decode()}"\n' for word in sorted(words)) or "# none\n")
    return path


def with_earlier(binaries, row):
    """How often the target ran in all runs that went on from one another."""
    path = binaries.parent / "executions.json"
    counts = json.loads(path.read_text()) if path.is_file() else {}
    counts[row["target"]] = counts.get(row["target"], 0) + row["executions"]
    path.write_text(json.dumps(counts, indent=1) + "\n")
    return counts[row["target"]]


def show(binaries, row):
    rate = row["executions"] / max(row["seconds"], 1e-9)
    print(f"| {row['target']:<10} | {row['executions']:>11} | {rate:>8.0f} | "
          f"{with_earlier(binaries, row):>11} | {row['covered']:>7} | "
          f"{row['inputs']:>6} | {'kept' if row['code'] == 0 else 'BROKEN':<8} |", flush=True)


def explain(binaries, row):
    lines = row["said"].splitlines()
    telling = [line for line in lines if re.search(
        r"broken promise|SUMMARY|ERROR: |runtime error|Test unit written", line)]
    print(f"\n{row['target']}:")
    print("\n".join(telling or lines[-12:]))
    found = re.findall(r"Test unit written to (\S+)", row["said"])
    if found:
        print(f"again: BRINDLE_FUZZ_TARGET={row['target']} {binaries}/fuzzer {found[-1]}")


def stop(*_):
    stopped.set()
    for process in list(running):
        os.killpg(process.pid, signal.SIGINT)


def arguments():
    words = sys.argv[1:]
    if not words or len(words) > 3:
        usage("takes a folder, a target and seconds")
    binaries = pathlib.Path(words[0])
    written = subprocess.run([binaries / "write_seeds", binaries.parent / "seeds"], text=True,
                             check=True, stdout=subprocess.PIPE)
    targets = written.stdout.split()
    if len(words) > 1 and words[1] != "all":
        if words[1] not in targets:
            usage(f"no target '{words[1]}': all, {', '.join(targets)}")
        targets = [words[1]]
    seconds = words[2] if len(words) > 2 else "60"
    if not re.fullmatch(r"\d+", seconds) or int(seconds) == 0:
        usage(f"'{seconds}' is no number of seconds")
    return binaries.resolve(), targets, int(seconds)


def main():
    binaries, targets, seconds = arguments()
    signal.signal(signal.SIGINT, stop)
    signal.signal(signal.SIGTERM, stop)
    workers = min(os.cpu_count() or 1, len(targets))
    print("| target     |  executions | a second |      in all | covered | inputs | promises |")
    print("|---|---|---|---|---|---|---|", flush=True)
    rows = []
    with ThreadPoolExecutor(workers) as pool:
        for row in pool.map(lambda target: None if stopped.is_set() else
                            fuzz(binaries, target, seconds * workers / len(targets)), targets):
            if row is not None:
                show(binaries, row)
                rows.append(row)
    if stopped.is_set():
        print("fuzz: cancelled", file=sys.stderr)
        return 130
    broken = [row for row in rows if row["code"] != 0]
    for row in broken:
        explain(binaries, row)
    print(f"\ncovered: edges of the {rows[0]['edges']} that the library has; "
          f"{sum(row['executions'] for row in rows)} executions")
    return 1 if broken or not all(row["executions"] for row in rows) else 0


sys.exit(main())
