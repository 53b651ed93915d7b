#!/usr/bin/python3
"""Measures Brindle beside what a user would take instead, on the same meshes and in one run, and prints
one table.

    scripts/peers.py build/release/apps/brindle/brindle [--sources FOLDER] [--task WORDS] [--csv ALL.csv]
                     [MESH...]

FOLDER holds the sources of geometry-central, instant-meshes and libigl, those that are there; they are
built outside of it, with drivers of ours (peers/), and stay as they are. Without it, only ParaView's
Surface LIC is beside Brindle, where ParaView is installed. Exits with 0 if all was measured or refused
with a reason, 1 if something crashed, hung or could not be built, 2 on wrong usage, 130 where Ctrl-C
ended it.
"""

import argparse
import csv
import io
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile

import zoo

ROOT = pathlib.Path(__file__).resolve().parent.parent
SHAPES = ("shape:molecule", "shape:box", "shape:vessels")
DIRECTION = "0.31,0.9,0.27"
SIZE = "1280x720"
TIMES = ("prepare_ms", "field_ms", "pattern_ms", "picture_ms")
COUNTS = ("field_singularities", "branches_beyond")
COLUMNS = ("mesh", "vertices", "task", "by", "outcome", *TIMES, "processor_s", *COUNTS,
           "angle_error_mean_deg", "why")
HEADS = {"mesh": "mesh", "vertices": "vertices", "task": "what", "by": "by",
         "prepare_ms": "prepare, ms", "field_ms": "field, ms", "pattern_ms": "pattern, ms",
         "picture_ms": "picture, ms", "processor_s": "processor, s",
         "field_singularities": "singularities", "branches_beyond": "branches beyond",
         "angle_error_mean_deg": "angle, °"}

# What a driver needs of a peer's sources; what lies in a submodule of theirs comes with it.
SOURCES = {
    "geometry-central": ("CMakeLists.txt", "src/surface/stripe_patterns.cpp",
                         "src/surface/direction_fields.cpp", "deps/happly/happly.h"),
    "instant-meshes": ("src/field.cpp", "src/hierarchy.cpp", "src/subdivide.cpp", "ext/rply/rply.c",
                       "ext/dset/dset.h", "ext/pcg32/pcg32.h"),
    "libigl": ("include/igl/principal_curvature.h",),
}
PARAVIEW = "paraview"
TASKS = ("stripes, smooth field", "the same, geometry-central's field", "stripes, a frame", "crosses",
         "stripes, curvature", "a picture")


class Failed(Exception):
    """What ended a measurement: an outcome and why."""

    def __init__(self, outcome, why):
        super().__init__(why)
        self.outcome, self.why = outcome, why


# --- what is there

def missing_of(name, folder):
    """Why a peer cannot be built from the folder, or None."""
    home = folder / name
    if not home.is_dir():
        return f"no folder {home}"
    absent = [part for part in SOURCES[name] if not (home / part).is_file()]
    if not absent:
        return None
    modules = home / ".gitmodules"
    listed = modules.read_text(errors="replace") if modules.is_file() else ""
    inside = sorted({str(pathlib.Path(part).parent) for part in absent
                     if f"path = {pathlib.Path(part).parent}" in listed})
    remedy = f"; try: git -C {home} submodule update --init {' '.join(inside)}" if inside else ""
    return f"{home} lacks {', '.join(absent)}{remedy}"


def last_error(text):
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    errors = [line for line in lines if "error" in line.lower()]
    return zoo.plain((errors or lines or ["nothing was said"])[0])


def built(name, sources, build):
    """The driver of a peer. Fails with the compiler's first complaint and where the rest is."""
    folder, log = build / name, build / f"{name}.log"
    cache = folder / "CMakeCache.txt"
    where = f"PEER_SOURCES:PATH={sources}"
    if cache.is_file() and where not in cache.read_text().splitlines():
        shutil.rmtree(folder)
    folder.mkdir(parents=True, exist_ok=True)
    print(f"peers: building {name}; see {log}", file=sys.stderr, flush=True)
    steps = (["cmake", "-S", str(ROOT / "peers"), "-B", str(folder), f"-DPEER={name}", f"-D{where}"],
             ["cmake", "--build", str(folder), "--target", "peer", "-j", str(os.cpu_count() or 1)])
    said = ""
    for step in steps:
        try:
            done = subprocess.run(step, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, errors="replace")
        except OSError as error:
            raise Failed("not built", f"{step[0]}: {error.strerror}") from None
        said += done.stdout
        log.write_text(said)
        if done.returncode != 0:
            raise Failed("not built", f"{last_error(done.stdout)} (all of it is in {log})")
    return folder / "peer"


def commit_of(sources):
    if not (sources / ".git").exists() or not shutil.which("git"):
        return None
    done = subprocess.run(["git", "-C", str(sources), "rev-parse", "--short=12", "HEAD"],
                          capture_output=True, text=True)
    return done.stdout.strip() or None


def find_peers(arguments):
    """Of every peer that was asked for its driver, or why there is none."""
    drivers, notes = {}, {}
    for name in arguments.peer:
        if name == PARAVIEW:
            lacking = [word for word in ("pvpython", "xvfb-run") if not shutil.which(word)]
            if lacking:
                notes[name] = ("missing", f"{' and '.join(lacking)} not found in PATH; in Debian: "
                               "apt-get install paraview python3-paraview xvfb xauth")
            else:
                drivers[name] = shutil.which("pvpython")
        elif arguments.sources is None:
            notes[name] = ("missing", "without --sources FOLDER there is nothing to build it from")
        elif why := missing_of(name, arguments.sources):
            notes[name] = ("missing", why)
        else:
            try:
                drivers[name] = str(built(name, arguments.sources / name, arguments.build))
            except Failed as failed:
                notes[name] = (failed.outcome, failed.why)
    return drivers, notes


# --- one run

def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def ending(code):
    """A shell in between, as xvfb-run is, adds 128 to the signal."""
    number = -code if code < 0 else code - 128
    try:
        return f"signal {signal.Signals(number).name}"
    except ValueError:
        return f"exit code {code}"


class Bench:
    """Runs programs on one mesh, in a folder that goes when all is done."""

    def __init__(self, arguments, drivers, folder):
        self.tool, self.drivers, self.folder = arguments.tool, drivers, folder
        self.threads, self.seconds = arguments.threads, arguments.seconds
        self.benchmarks, self.bench_seconds = arguments.benchmarks, arguments.bench_seconds
        self.mesh, self.frequency, self.stripes = folder / "mesh.obj", 0.0, arguments.stripes

    def run(self, words, said_by):
        """The processor's time that the whole program took, in seconds; others on the machine hardly
        change it."""
        # Mesa draws on the processor, for all alike; libraries that count processors by themselves
        # are told as well.
        limits = [f"{name}={self.threads}"
                  for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "LP_NUM_THREADS")]
        before = processor_time()
        code, out, _ = zoo.run(["/usr/bin/env", "LIBGL_ALWAYS_SOFTWARE=1", *limits,
                                *map(str, words)], self.seconds)
        if code is None:
            raise Failed("hung", f"no end within {self.seconds:g} s")
        own = [line for line in out.splitlines() if line.startswith(said_by + ": ")]
        said = zoo.plain(own[0].removeprefix(said_by + ": ")) if own else last_error(out)
        if code == 1 and own:
            raise Failed("refused", said.removeprefix(f"{self.mesh}: "))
        if code != 0:
            raise Failed("crashed", f"{ending(code)}: {said}")
        return processor_time() - before

    def report(self, words, said_by, name="report.json"):
        path = self.folder / name
        path.unlink(missing_ok=True)
        took = self.run([path if word is REPORT else word for word in words], said_by)
        try:
            return {"processor_s": took, **json.loads(path.read_text())}
        except (OSError, ValueError) as error:
            raise Failed("crashed", f"it ended well, but without a report: {error}") from None

    def stripe(self, *words):
        """A row of `brindle stripe`."""
        read = self.report([self.tool, "stripe", self.mesh, "--quiet", "--threads", self.threads,
                            "--frequency", f"{self.frequency:.9g}", "--report", REPORT, *words],
                           "brindle")
        took = read["milliseconds"]
        own_field = not any(str(word).endswith(".csv") for word in words)
        # A singularity of crosses is one of both waves, and counts twice among their branches.
        waves = 2 if "--cross" in words else 1
        return {"vertices": read["vertices"], "processor_s": read["processor_s"],
                "prepare_ms": took["topology"], "field_ms": took["field"] if own_field else None,
                "pattern_ms": sum(took.get(key, 0) for key in ("frequency", "couple", "solve", "merge", "pattern")),
                "field_singularities": read["field_singularities"],
                "branches_beyond": read["branches"] - waves * read["field_singularities"],
                "angle_error_mean_deg": read["angle_error_mean_deg"]}

    def peer(self, name, *words):
        return self.report([self.drivers[name], self.mesh, "--report", REPORT, *words], "peer")

    def field(self, name):
        """Where a peer leaves its directions."""
        path = self.folder / f"{name}.csv"
        if not path.is_file():
            raise Failed("skipped", f"{name} has left no field")
        return path

    def prepare(self, mesh, stripes):
        """The mesh as all read it, and one frequency for all. Without creases: what is split there has
        copies of vertices, at which the others' surfaces would end."""
        read = self.report([self.tool, "stripe", mesh, "--quiet", "--stripes", f"{stripes:.9g}",
                            "--crease-angle", 180, "--output", self.mesh, "--report", REPORT],
                           "brindle")
        if read.get("kind") != "mesh":
            raise Failed("refused", "it has no triangles")
        self.frequency = read["frequency_max"]
        return read["vertices"]


REPORT = object()


# --- what is measured: a task, by whom, and how

def of_geometry_central(bench):
    return bench.peer("geometry-central", "--frequency", f"{bench.frequency:.9g}",
                      "--write-field", bench.folder / "geometry-central.csv")


def of_instant_meshes(*words):
    return lambda bench: bench.peer("instant-meshes", "--spacing", f"{1 / bench.frequency:.9g}",
                                    "--threads", bench.threads, *words)


def of_libigl(bench):
    """libigl's directions, and Brindle's stripes across them."""
    field = bench.peer("libigl", "--write-field", bench.folder / "libigl.csv")
    stripes = bench.stripe("--field", bench.field("libigl"))
    return {**stripes, "field_ms": field["field_ms"],
            "processor_s": field["processor_s"] + stripes["processor_s"]}


def striped(*words):
    return lambda bench: bench.stripe(*words)


def along_field_of(name, *words):
    return lambda bench: bench.stripe("--field", bench.field(name), *words)


def of_surface_lic(bench):
    vectors = bench.folder / "vectors.vtp"
    bench.run([bench.tool, "stripe", bench.mesh, "--quiet", "--direction", DIRECTION, "--along",
               "--output", vectors], "brindle")
    read = bench.report(["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset",
                         bench.drivers[PARAVIEW], "--force-offscreen-rendering",
                         ROOT / "peers" / "surface_lic.py", vectors, "direction", REPORT,
                         "--size", SIZE, "--frames", 3], "peer")
    # The whole program draws several frames.
    return {**read, "processor_s": None}


def benched(bench, name):
    """A result of `brindle-bench`, with as many threads as were asked for; frames and pictures are
    measured once a turn."""
    path = bench.folder / "bench.json"
    if not path.exists():
        if not bench.benchmarks.is_file():
            raise Failed("skipped", f"no {bench.benchmarks}; configure with -DBRINDLE_BENCH=ON")
        bench.report([bench.benchmarks, bench.mesh, "--subdivide", 0, "--threads", bench.threads,
                      "--stripes", f"{bench.stripes:.9g}", f"--benchmark_min_time={bench.bench_seconds}",
                      f"--benchmark_filter=^(topology|frame|picture_.*)/.*/threads:{bench.threads}/",
                      f"--benchmark_out={path}"], "brindle-bench", "bench.json")
    for run in json.loads(path.read_text())["benchmarks"]:
        if run["name"].startswith(f"{name}/"):
            return run
    raise Failed("skipped", "no OpenGL here")


def frame(bench):
    took = benched(bench, "frame")
    return {"vertices": int(took["vertices"]), "prepare_ms": benched(bench, "topology")["min_ms"],
            "pattern_ms": took["min_ms"]}


def picture(quality):
    def measure(bench):
        took = benched(bench, f"picture_{quality}")
        return {"vertices": int(took["vertices"]), "picture_ms": took["min_ms"]}
    return measure


def plan(drivers, tasks):
    """Tasks in the order in which they run: a field is made before others take it. Only those of one of
    these names, if any are named."""
    steps = []

    def add(task, by, measure):
        if not tasks or task in tasks:
            steps.append((task, by, measure))

    if "geometry-central" in drivers:
        add("stripes, smooth field", "geometry-central", of_geometry_central)
    add("stripes, smooth field", "Brindle", striped())
    if "geometry-central" in drivers:
        theirs = "the same, geometry-central's field"
        add(theirs, "Brindle, `--solver global`", along_field_of("geometry-central", "--solver", "global"))
        add(theirs, "Brindle", along_field_of("geometry-central"))
    add("stripes, a frame", "Brindle", frame)
    if "instant-meshes" in drivers:
        add("crosses", "Instant Meshes", of_instant_meshes())
        add("crosses", "Instant Meshes, `-i`", of_instant_meshes("--intrinsic", "yes"))
    add("crosses", "Brindle, `--cross`", striped("--cross"))
    add("crosses", "Brindle, `--cross --slack 0.3`", striped("--cross", "--slack", 0.3))
    add("crosses", "Brindle, `--cross --normal-radius 1%`",
        striped("--cross", "--normal-radius", "1%"))
    add("crosses", "Brindle, `--cross --normal-radius 1% --cancel-branches 0`",
        striped("--cross", "--normal-radius", "1%", "--cancel-branches", 0))
    if "libigl" in drivers:
        add("stripes, curvature", "libigl, then Brindle", of_libigl)
    add("stripes, curvature", "Brindle, `raw-curvature`", striped("--field", "raw-curvature"))
    add("stripes, curvature", "Brindle, `curvature`", striped("--field", "curvature"))
    if PARAVIEW in drivers:
        add("a picture", "ParaView, Surface LIC", of_surface_lic)
    add("a picture", "Brindle, interactive", picture("interactive"))
    add("a picture", "Brindle, final", picture("final"))
    return steps


# --- rows

def merged(row, runs):
    """Times are the least of all runs; counts that differ are given as a range."""
    for key in ("vertices", *TIMES, "processor_s", *COUNTS, "angle_error_mean_deg"):
        values = [run[key] for run in runs if run.get(key) is not None]
        if not values:
            continue
        if key in (*TIMES, "processor_s"):
            row[key] = min(values)
        elif key == "angle_error_mean_deg":
            row[key] = sorted(values)[len(values) // 2]
        else:
            least, most = int(min(values)), int(max(values))
            row[key] = least if least == most else f"{least} to {most}"
    row["runs"] = runs
    return row


def measure_mesh(arguments, drivers, mesh, folder):
    bench = Bench(arguments, drivers, folder)
    name = mesh.removeprefix("shape:") if mesh.startswith("shape:") else pathlib.Path(mesh).name
    name = zoo.plain(name)
    try:
        vertices = bench.prepare(mesh, arguments.stripes)
    except Failed as failed:
        return [{"mesh": name, "task": "", "by": "Brindle", "outcome": failed.outcome,
                 "why": failed.why}]
    steps = plan(drivers, arguments.task)
    runs, ended = [[] for _ in steps], {}
    for turn in range(arguments.repeat):
        (folder / "bench.json").unlink(missing_ok=True)
        # One after the other, so that what else the machine does hits all alike.
        for i, (task, by, measure) in enumerate(steps):
            if i in ended:
                continue
            print(f"peers: {name}, run {turn + 1} of {arguments.repeat}: {task}, {by}", file=sys.stderr,
                  flush=True)
            try:
                runs[i].append(measure(bench))
            except Failed as failed:
                ended[i] = failed
    rows = []
    for i, (task, by, _) in enumerate(steps):
        row = {"mesh": name, "vertices": vertices, "task": task, "by": by}
        if i in ended:
            rows.append({**row, "outcome": ended[i].outcome, "why": ended[i].why})
        else:
            rows.append(merged({**row, "outcome": "measured", "why": ""}, runs[i]))
    return rows


# --- what is shown

def cell(row, column):
    value = row.get(column)
    if value is None:
        return ""
    if column in TIMES:
        return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"
    if isinstance(value, int):
        return f"{value:,}"
    return f"{value:.2f}" if isinstance(value, float) else str(value)


def show(rows):
    """Columns that nothing is in are left out."""
    measured = [row for row in rows if row["outcome"] == "measured"]
    columns = [c for c in HEADS if c in ("mesh", "task", "by") or any(cell(r, c) for r in measured)]
    print("| " + " | ".join(HEADS[c] for c in columns) + " |")
    print("|" + "".join("---|" if c in ("mesh", "task", "by") else "--:|" for c in columns))
    for row in rows:
        cells = [cell(row, c) for c in columns]
        if row["outcome"] != "measured":
            cells = cells[:columns.index("by") + 1]
            cells += [f"{row['outcome']}: {row['why']}"] + [""] * (len(columns) - len(cells) - 1)
        print("| " + " | ".join(c.replace("|", "\\|") for c in cells) + " |")


def load_before():
    return os.getloadavg()[0]


def processor():
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return "unknown"


def write_whole(path, text):
    """The file is there as it was or as it should be; says whether it could be written."""
    beside = path.with_name(f".{path.name}.part")
    try:
        beside.write_text(text)
        beside.replace(path)
        return True
    except OSError as error:
        print(f"peers: {path} cannot be written: {error.strerror}", file=sys.stderr)
        return False


def write_outputs(arguments, about, rows):
    table = io.StringIO(newline="")
    writer = csv.DictWriter(table, COLUMNS, extrasaction="ignore")
    writer.writeheader()
    writer.writerows(rows)
    figures = json.dumps({**about, "rows": rows}, indent=1, default=str) + "\n"
    outputs = ((arguments.csv, table.getvalue()), (arguments.json, figures))
    return all([write_whole(path, text) for path, text in outputs if path])


# --- the command line

def positive(text):
    value = float(text)
    if not 0 < value < 1e9:
        raise argparse.ArgumentTypeError(f"'{text}' must be above 0")
    return value


def count(text):
    value = int(text)
    if not 1 <= value <= 1000:
        raise argparse.ArgumentTypeError(f"'{text}' must be from 1 to 1000")
    return value


def parsed(words):
    processors = len(os.sched_getaffinity(0))
    names = (*SOURCES, PARAVIEW)
    parser = argparse.ArgumentParser(
        prog="./dev peers", usage="%(prog)s [--sources FOLDER] [OPTIONS] [MESH...]",
        description="Measures Brindle beside what a user would take instead, in one table.",
        epilog="example: ./dev peers --sources ~/sources --repeat 5 --csv all.csv horse.ply")
    parser.add_argument("tool", help=argparse.SUPPRESS)
    parser.add_argument("meshes", nargs="*", metavar="MESH",
                        help=f"files or built-in shapes (default: {' '.join(SHAPES)})")
    parser.add_argument("--sources", type=pathlib.Path, metavar="FOLDER",
                        help=f"where the folders {', '.join(SOURCES)} are; those that are there are built")
    parser.add_argument("--peer", action="append", choices=names, metavar="NAME",
                        help=f"only this one, of {', '.join(names)}; repeatable")
    parser.add_argument("--task", action="append", choices=TASKS, metavar="WORDS",
                        help=f"only this one, of {'; '.join(TASKS)}; repeatable")
    parser.add_argument("--stripes", type=positive, default=40.0, metavar="N",
                        help="along the diagonal of the bounding box (default 40)")
    parser.add_argument("--repeat", type=count, default=3, metavar="N",
                        help="runs of everything; the least times count (default 3)")
    parser.add_argument("--threads", type=count, default=processors, metavar="N",
                        help=f"for all alike (default {processors}: all that are here)")
    parser.add_argument("--seconds", type=positive, default=300.0, metavar="S",
                        help="what takes longer has no end (default 300)")
    parser.add_argument("--csv", type=pathlib.Path, metavar="FILE",
                        help="the table, with outcomes and reasons")
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE",
                        help="the same, with the machine and every single run")
    parser.add_argument("--bench-seconds", type=positive, default=0.3, help=argparse.SUPPRESS)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "peers",
                        help=argparse.SUPPRESS)
    arguments = parser.parse_intermixed_args(words)
    arguments.meshes = arguments.meshes or list(SHAPES)
    arguments.peer = list(dict.fromkeys(arguments.peer or names))
    arguments.build = arguments.build.absolute()
    # Both are of one build.
    arguments.benchmarks = pathlib.Path(arguments.tool).absolute().parents[2] / "bench" / "brindle-bench"
    if arguments.threads > processors:
        parser.error(f"--threads {arguments.threads}: there are {processors} here")
    for mesh in arguments.meshes:
        if not mesh.startswith("shape:") and not pathlib.Path(mesh).is_file():
            parser.error(f"'{mesh}' is no file, nor a built-in shape such as {SHAPES[0]}")
    check_outputs(parser, arguments)
    check_sources(parser, arguments)
    return arguments


def check_outputs(parser, arguments):
    taken = {pathlib.Path(mesh).resolve() for mesh in arguments.meshes}
    for output in filter(None, (arguments.csv, arguments.json)):
        if not output.absolute().parent.is_dir():
            parser.error(f"there is no folder for '{output}'")
        if output.resolve() in taken:
            parser.error(f"'{output}' would overwrite an input or another output")
        taken.add(output.resolve())


def check_sources(parser, arguments):
    if arguments.sources is None:
        return
    if not arguments.sources.is_dir():
        parser.error(f"'{arguments.sources}' is no folder")
    arguments.sources = arguments.sources.absolute()
    asked = [name for name in SOURCES if name in arguments.peer]
    missing = {name: missing_of(name, arguments.sources) for name in asked}
    if all(missing.values()):
        parser.error("--sources has nothing that can be built: " + "; ".join(missing.values())
                     if asked else "--sources has no effect with --peer paraview alone")


def main():
    arguments = parsed(sys.argv[1:])
    drivers, notes = find_peers(arguments)
    about = {"processor": processor(), "threads": arguments.threads, "repeat": arguments.repeat,
             "stripes": arguments.stripes, "load_before": load_before(),
             "peers": {name: {"sources": str(arguments.sources / name) if name in SOURCES else driver,
                              "commit": commit_of(arguments.sources / name) if name in SOURCES else None}
                       for name, driver in drivers.items()},
             "missing": {name: why for name, (_, why) in notes.items()}}
    print(f"machine: {about['processor']}, load before the run {about['load_before']:.1f}; threads: "
          f"{arguments.threads}; the least times of {arguments.repeat} runs; {arguments.stripes:g} stripes")
    rows = []
    for mesh in arguments.meshes:
        with tempfile.TemporaryDirectory(prefix="brindle_peers_") as folder:
            rows += measure_mesh(arguments, drivers, mesh, pathlib.Path(folder))
    print()
    show(rows)
    for name, (outcome, why) in notes.items():
        print(f"\n{name} is {outcome}: {why}")
    written = write_outputs(arguments, about, rows)
    bad = [row for row in rows if row["outcome"] in ("crashed", "hung")
           or (row["outcome"] == "refused" and row["by"].startswith("Brindle"))]
    return 1 if bad or not written or any(outcome == "not built" for outcome, _ in notes.values()) else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
