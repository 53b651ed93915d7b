#!/usr/bin/python3
"""Runs the commands of the documentation, checks its links, and draws its pictures.

    scripts/check_docs.py build/release/apps/brindle/brindle [PAGE...] [--across]
                          [--small] [--pictures] [--models FOLDER] [--keep FOLDER]

With pages only these are checked, so that pages can be checked beside each other; --across checks
only what concerns all of them together.

Every command in a fenced ```sh block of README.md, docs/*.md and docs/gallery/*.md must end with 0.
The commands of one page run one after the other in a folder of their own, so a page makes the files
that it reads. A block may say more behind its "sh":

    ```sh models    reads one of the public scans (horse.ply and so on). Without --models the command
                    line alone is checked: the tool must miss the file, not misunderstand the options.
    ```sh no-run    is not run; the text around it says why.

Commands of other programs that build or check (./dev, cmake, ctest, scripts/) are left out.

Also checked: a picture in a page is made by a command of that page, or of one of its folder that it
links to; no picture is larger than 300 kB (1.5 MB if it moves) or without a page; links lead somewhere, and so do
sources that cite a page and a section; a C++ block is part of the example program that its page names;
docs/report.md explains every key of the reports that its commands write.

--small draws thumbnails of little data, which is enough to see that commands work. --pictures copies the
pictures to docs/images. Ends with 0 if all is well and 1 if not.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import textwrap

import public_names

ROOT = pathlib.Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images"
LARGEST_PICTURE = 300_000  # bytes
LARGEST_MOVING_PICTURE = 1_500_000
THUMBNAIL = "96x72"
LEFT_OUT = ("./dev", "cmake", "ctest", "scripts/")
RUN = ("brindle", "awk", "printf")
DRAW = ("brindle", "python3 paraview/", "node web/", "blender", "xvfb-run")  # the last for windows, not run
MARKS = {"models", "no-run"}
MISSING_FILE = 1  # what the tool ends with
OPEN_KEYS = {"options", "limits"}  # of reports: what they hold depends on the command, the driver

CITATION = re.compile(r'docs/(\w+\.md)(?:,\s*(?:///?\s*)?"([^"]+)")?')

Command = collections.namedtuple("Command", "line text mark")
Block = collections.namedtuple("Block", "line language marks lines")


class Page:
    def __init__(self, path):
        self.path = path
        self.name = str(path.relative_to(ROOT))
        self.text = path.read_text()
        self.blocks = list(fenced_blocks(self.text))
        self.prose = prose_of(self.text)
        self.failures = []

    def fail(self, line, what):
        self.failures.append(f"{self.name}:{line}: {what}")

    def commands(self):
        """The shell commands, lines that end in a backslash joined."""
        for block in self.blocks:
            if block.language != "sh":
                continue
            unknown = set(block.marks) - MARKS
            if unknown:
                self.fail(block.line, f"unknown mark {', '.join(sorted(unknown))}")
            mark = block.marks[0] if block.marks else ""
            begun, first = "", 0
            for number, line in enumerate(block.lines, block.line + 1):
                first = first if begun else number
                begun += line.rstrip("\\").strip() + " " if line.endswith("\\") else line
                if line.endswith("\\"):
                    continue
                text, begun = begun.strip(), ""
                if text and not text.startswith(("#",) + LEFT_OUT):
                    yield Command(first, text, mark)

    def pages_linked(self):
        """The pages of the same folder that the page links to."""
        return re.findall(r"\]\((\w+\.md)\)", self.prose)

    def pictures(self):
        """The names of the pictures that the page shows."""
        links = re.findall(r"!\[[^\]]*\]\(([^)]*)\)", self.prose)
        links += re.findall(r'<img[^>]*\bsrc="([^"]*)"', self.prose)
        return [pathlib.PurePath(link).name for link in links]


def fenced_blocks(text):
    block = None
    for number, line in enumerate(text.splitlines(), 1):
        fence = line.startswith("```")
        if fence and block is None:
            words = line[3:].split()
            block = Block(number, words[0] if words else "", words[1:], [])
        elif fence:
            yield block
            block = None
        elif block is not None:
            block.lines.append(line)


def prose_of(text):
    """The text with fenced blocks emptied, so that lines keep their numbers."""
    lines, inside = [], False
    for line in text.splitlines():
        fence = line.startswith("```")
        lines.append("" if fence or inside else line)
        inside ^= fence
    return "\n".join(lines)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


# --- commands ---------------------------------------------------------------------------------


def output_paths(text):
    """The files that a command is told to write."""
    words = shlex.split(text)
    return [after for word, after in zip(words, words[1:]) if word in ("-o", "--output")]


def makes(output, name):
    """Whether the output, maybe with a frame number such as %02d in it, is or has this file."""
    pattern = re.sub(r"%0?\d*d", r"\\d+", re.escape(output))
    return re.fullmatch(pattern, name) is not None


def thumbnail(text):
    """The same command with a small picture, and as little data as there may be: surfaces of implicit
    functions are coarse, the gallery's data small, and reliefs have few tiles."""
    text = re.sub(r"shape:(vessels|molecule|box|trefoil)\b(?!\S*resolution)", r"shape:\1,resolution=40",
                  text)
    if re.match(r"brindle gallery \w", text) and "--surface" not in text and \
            (output_paths(text) or "--data" in text):
        text = re.sub(r" --detail \S+", "", text) + " --detail 0.25"
    if text.startswith("brindle relief"):
        text = re.sub(r"--spacing (\d+)%", lambda found: f"--spacing {3 * int(found[1])}%", text)
    if re.search(r"--size \S+", text):
        return re.sub(r"--size \S+", f"--size {THUMBNAIL}", text)
    draws = any(path.endswith((".png", ".svg")) for path in output_paths(text))
    return f"{text} --size {THUMBNAIL}" if draws else text


def run_page(page, arguments, folder):
    """Runs all commands of the page in the folder."""
    programs = folder / ".bin"
    programs.mkdir(parents=True)
    (programs / "brindle").symlink_to(pathlib.Path(arguments.brindle).resolve())
    if arguments.models:
        for model in arguments.models.iterdir():
            (folder / model.name).symlink_to(model.resolve())
    environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}")
    for command in page.commands():
        if command.mark == "no-run":
            continue
        if not command.text.startswith(RUN):
            page.fail(command.line, f"unknown program; mark the block 'no-run': {command.text}")
            continue
        without_model = command.mark == "models" and not arguments.models
        if without_model and not command.text.startswith("brindle"):
            continue
        text = thumbnail(command.text) if arguments.small else command.text
        result = subprocess.run(["/bin/sh", "-e", "-c", text], cwd=folder, env=environment,
                                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE, text=True, check=False)
        wanted = MISSING_FILE if without_model else 0
        if result.returncode != wanted:
            said = textwrap.indent(result.stderr.strip() or "(no message)", "    ")
            page.fail(command.line,
                      f"ended with {result.returncode}, not {wanted}: {command.text}\n{said}")


# --- pictures ---------------------------------------------------------------------------------


def check_pictures(page, every_page):
    """Every picture has one command that makes it, here or, if not, on a page that is linked to."""
    linked = {(page.path.parent / link).resolve() for link in page.pages_linked()}
    own = outputs_of([page])
    others = outputs_of([other for other in every_page if other.path in linked])
    for name in page.pictures():
        makers = ([output for output in own if makes(output, name)] or
                  [output for output in others if makes(output, name)])
        if len(makers) != 1:
            page.fail(1, f"picture {name} is made by {len(makers)} commands of the page, not by 1")


def outputs_of(pages):
    return [path for page in pages for command in page.commands()
            if command.text.startswith(DRAW) for path in output_paths(command.text)]


def copy_pictures(page, folder):
    for name in page.pictures():
        if (folder / name).exists():
            shutil.copyfile(folder / name, IMAGES / name)


def check_picture_files(pages):
    shown = {name for page in pages for name in page.pictures()}
    present = {path.name for path in IMAGES.iterdir()}
    failures = [f"docs/images/{name} is missing" for name in sorted(shown - present)]
    failures += [f"docs/images/{name} is shown on no page" for name in sorted(present - shown)]
    for path in sorted(IMAGES.iterdir()):
        largest = LARGEST_MOVING_PICTURE if path.suffix == ".gif" else LARGEST_PICTURE
        if path.stat().st_size > largest:
            failures.append(f"docs/images/{path.name} has {path.stat().st_size} bytes")
    return failures


# --- links, examples, report --------------------------------------------------------------------


def anchors_of(text):
    """What a link's # may name: headings in lower case, without signs, spaces turned to hyphens."""
    headings = re.findall(r"^#+ (.*)$", prose_of(text), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-")
            for heading in headings}


def check_links(page):
    for match in re.finditer(r"(?:\]\(|\bsrc=\")([^)\"\s]+)[)\"]", page.prose):
        target, line = match.group(1), line_of(page.prose, match.start())
        if re.match(r"\w+:", target):
            continue
        file, _, anchor = target.partition("#")
        path = (page.path.parent / file).resolve() if file else page.path
        if not path.exists():
            page.fail(line, f"link to nothing: {target}")
        elif anchor and anchor not in anchors_of(path.read_text()):
            page.fail(line, f"no such section: {target}")


def check_other_links():
    """Links of the files beside README.md, whose commands are others'."""
    pages = [Page(path) for path in [*sorted(ROOT.glob("*.md")), ROOT / "web/package/README.md"]
             if path != ROOT / "README.md"]
    for page in pages:
        check_links(page)
    return [failure for page in pages for failure in page.failures]


def check_cited_headers():
    """Headers that the comments of public ones name are installed, too."""
    public = ROOT / "include" / "brindle"
    return [f"{path.name} cites {header}, which is not installed"
            for path in sorted(public.glob("*.h"))
            for header in re.findall(r"//.*?\b(\w+\.h)\b", path.read_text())
            if not (public / header).exists()]


def check_citations():
    """Sections that comments in headers and sources name by their titles are there."""
    failures = []
    for folder in ("include", "src", "apps"):
        for path in sorted((ROOT / folder).rglob("*.[hc]*")):
            for match in CITATION.finditer(path.read_text(errors="replace")):
                page, title = ROOT / "docs" / match[1], match[2] and " ".join(match[2].split())
                cited = f"{path.relative_to(ROOT)} cites docs/{match[1]}"
                if not page.exists():
                    failures.append(f"{cited}, which is no page")
                elif title and not re.search(rf"^#+ {re.escape(title)}$", page.read_text(), re.M):
                    failures.append(f'{cited}, "{title}", which is no section')
    return failures


def check_public_names():
    """docs/headers.md lists the declarations of the public headers."""
    if (ROOT / "docs/headers.md").read_text() == public_names.page():
        return []
    return ["docs/headers.md does not list the declarations of the public headers; run scripts/public_names.py"]


def check_examples(page):
    """C++ or C in a page that names an example program is part of that program."""
    names = re.findall(r"docs/examples/(\w+\.(?:cpp|c)\b)", page.prose)
    if not names:
        return
    programs = [ROOT / "docs" / "examples" / name for name in names]
    known = "\n".join(without_indent(program.read_text()) for program in programs)
    for block in page.blocks:
        code = without_indent("\n".join(block.lines))
        if block.language in ("cpp", "c") and code not in known:
            page.fail(block.line, f"not part of {', '.join(names)}")


def without_indent(code):
    return "\n".join(line.strip() for line in code.splitlines())


def keys_of(value):
    if isinstance(value, dict):
        inner = [keys_of(item) for key, item in value.items() if key not in OPEN_KEYS]
        return set(value).union(*inner)
    if isinstance(value, list):
        return set().union(*(keys_of(item) for item in value))
    return set()


def check_report_keys(page, folder):
    """The keys that reports have are those in the first columns of the page's tables."""
    written = set()
    for path in folder.glob("*.json"):
        written |= keys_of(json.loads(path.read_text()))
    explained = set()
    for cell in re.findall(r"^\| *(`[^|]*`) *\|", page.prose, re.MULTILINE):
        explained |= {part for name in re.findall(r"`([^`]*)`", cell) for part in name.split(".")}
    for key in sorted(written - explained):
        page.fail(1, f"the report's key '{key}' is not explained")
    for key in sorted(explained - written):
        page.fail(1, f"no report has the key '{key}'")


# ------------------------------------------------------------------------------------------------


def check_page(page, every_page, arguments, folder):
    run_page(page, arguments, folder)
    check_pictures(page, every_page)
    check_links(page)
    check_examples(page)
    if page.path.name == "report.md":
        check_report_keys(page, folder)
    if arguments.pictures:
        copy_pictures(page, folder)
    return page


def check(arguments, folder):
    every_page = [Page(path) for path in [ROOT / "README.md", *sorted(ROOT.glob("docs/*.md")),
                                           *sorted(ROOT.glob("docs/gallery/*.md"))]]
    wanted = {pathlib.Path(name).resolve() for name in arguments.pages}
    unknown = wanted - {page.path for page in every_page}
    pages = [page for page in every_page
             if not arguments.across and (not wanted or page.path in wanted)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = [pool.submit(check_page, page, every_page, arguments,
                            folder / page.name.removesuffix(".md"))
                for page in pages]
        failures = [failure for job in jobs for failure in job.result().failures]
    failures += [f"{path} is no page" for path in sorted(unknown)]
    if not wanted:
        failures += (check_picture_files(every_page) + check_other_links() + check_citations()
                     + check_cited_headers() + check_public_names())
    for failure in failures:
        print(failure)
    commands = sum(1 for page in pages for command in page.commands() if command.mark != "no-run")
    print(f"{len(pages)} pages, {commands} commands, {len(failures)} failures")
    return 1 if failures else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("brindle", help="the tool")
    parser.add_argument("pages", nargs="*", help="only these (default: all)")
    parser.add_argument("--across", action="store_true", help="only what concerns all pages")
    parser.add_argument("--small", action="store_true", help="draw thumbnails")
    parser.add_argument("--pictures", action="store_true", help="copy pictures to docs/images")
    parser.add_argument("--models", type=pathlib.Path, help="where the public scans are")
    parser.add_argument("--keep", type=pathlib.Path, help="leave all that was written here")
    arguments = parser.parse_args()
    if arguments.pages and arguments.across:
        parser.error("--across is not for single pages")
    if arguments.small and arguments.pictures:
        parser.error("--pictures draws them at their full size: leave out --small")
    if arguments.models and not arguments.models.is_dir():
        print(f"no {arguments.models}: commands that read scans are checked, but not run")
        arguments.models = None
    if arguments.keep:
        return check(arguments, arguments.keep.resolve())
    with tempfile.TemporaryDirectory() as folder:
        return check(arguments, pathlib.Path(folder))


if __name__ == "__main__":
    sys.exit(main())
