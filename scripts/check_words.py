#!/usr/bin/env python3
"""Checks the language of the documentation.

usage: check_words.py [--help-texts BRINDLE] [PAGE...]

Prints FILE:LINE: MESSAGE for headings and sentences that open with What, Who, Whoever, Where or How far;
sentences of more than 30 words and terms that have a better name (TERMS), both outside tables and code;
pages with more words than their budget (BUDGETS), counted as by wc -w. Links are check_docs.py's.
Exits with 1 if it found any. With pages, it checks only these.
--help-texts lists the option texts of the tool with more than 70 characters; it never fails.
"""
import argparse
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "web/package/README.md"]
GENERATED = {"docs/headers.md"}
LONGEST_SENTENCE, LONGEST_HELP = 30, 70  # words, characters

# Words for one page, or for several together. Names are relative to docs/.
BUDGETS = [
    (640, "../CHANGELOG"), (900, "../README"), (650, "install"), (2210, "first_pattern python library"),
    (1800, "data"), (1300, "animate"), (1400, "textures"), (550, "relief"), (900, "cross_fields"), (1400, "curves"),
    (1200, "fabrication"), (500, "paths"), (900, "fewer_branches"), (1700, "illustration"), (600, "sharp_edges"),
    (1000, "samples point_clouds"), (1500, "paraview"), (1400, "window"), (1200, "web"), (1000, "gpu"),
    (1200, "distributed"), (1300, "files"), (1600, "report"), (900, "sessions"), (400, "glossary"),
    (2700, "method"), (800, "comparison"), (980, "benchmarks"), (2020, "architecture fuzzing tried"),
    (900, "gallery/README"), (400, "c"), (700, "blender"), (2800, "options"),
]

# Term: the field's name for it. Terms are regular expressions for whole words.
TERMS = {
    r"yield(s|ed|ing)?": "spacing tolerance",
    r"seen (at|from)": "smoothing",
    r"calm(er|ly)?": "branch avoidance; stable",
    r"merg(e|ed|ing) branches": "cancel branch pairs",
    r"figures?(?! \d)": "metric, image or motif",
    r"pieces?": "partition or connected component",
    r"rooms?|houses?": "module", r"makers?": "fabrication", r"told by": "identified",
    r"mend(s|ed|ing)?": "fix", r"anew|afresh": "again",
    r"refus(e|es|ed|ing|al|als)": "reject", r"wish(es)?": "request",
}
OPENING = re.compile(r"(What|Who|Whoever|Where|How far)\b")
SENTENCE_END = re.compile(r"(?<!e\.g)(?<!i\.e)(?<!\bal)(?<!\bcf)(?<!\bEq)(?<!\bFig)[.!?][)\"]*$")
SENTENCE_START = re.compile(r"[\"(`]*[A-Z0-9`]")


def plain(line):
    """The line as read: no markup, a code span is the word `x`."""
    line = re.sub(r"`+[^`]+`+", "`x`", line)
    line = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", line)
    return re.sub(r"<[^>]*>|\*", "", line).strip()


def blocks_of(text):
    """(kind, line number, lines) of every heading, paragraph and list item."""
    block, fenced = [], False
    for number, line in enumerate(text.splitlines() + [""], 1):
        fence = line.lstrip().startswith("```")
        heading = not fenced and line.startswith("#")
        code = fence or fenced or (not block and line.startswith("    "))
        skipped = code or heading or not line.strip() or line.lstrip()[0] in "|<"
        if block and (skipped or re.match(r"\s*([-*+]|\d+\.) ", line)):
            yield "prose", block
            block = []
        if heading:
            yield "heading", [(number, line.lstrip("# "))]
        elif not skipped:
            block.append((number, re.sub(r"^\s*([-*+]|\d+\.) ", "", line)))
        fenced ^= fence


def sentences_of(block):
    """(line number, text) of each sentence."""
    first, words = block[0][0], []
    for number, line in block:
        for word in plain(line).split():
            if words and SENTENCE_END.search(words[-1]) and SENTENCE_START.match(word):
                yield first, " ".join(words)
                words = []
            first = first if words else number
            words.append(word)
    yield first, " ".join(words)


def check_prose(text):
    for kind, block in blocks_of(text):
        for number, line in block:
            for term, better in TERMS.items():
                for match in re.finditer(rf"\b({term})\b", plain(line), re.IGNORECASE):
                    yield number, f"'{match[0]}': better {better}"
        for number, sentence in block if kind == "heading" else sentences_of(block):
            if opening := OPENING.match(sentence.lstrip("\"(`")):
                yield number, f"{kind} opens with '{opening[0]}': {sentence[:50]}"
            if kind == "prose" and (count := len(sentence.split())) > LONGEST_SENTENCE:
                yield number, f"sentence of {count} words: {sentence[:50]}"


def check_budgets(texts):
    budgeted = set()
    for budget, names in BUDGETS:
        pages = [f"docs/{name}.md".replace("docs/../", "") for name in names.split()]
        words = sum(len(texts[page].split()) for page in pages if page in texts)
        budgeted.update(pages)
        if words > budget:
            yield f"{pages[0]}:1: {words} words in {', '.join(pages)}: at most {budget}"
    yield from (f"{name}:1: no budget of words" for name in texts
                if name.startswith("docs/") and name not in budgeted)


def list_help_texts(tool):
    commands = re.findall(r"^  (\w+)  +\w", subprocess.check_output([tool, "--help"], text=True), re.M)
    for command in commands:
        text = subprocess.check_output([tool, command, "--help-all"], text=True)
        for option, help_text in re.findall(r"^  (-\S+).*?(?:\n {20,}|  +)(\S.*)$", text, re.M):
            if len(help_text) > LONGEST_HELP:
                print(f"{command} {option}: {len(help_text)} characters: {help_text[:50]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", nargs="*", type=pathlib.Path, metavar="PAGE")
    parser.add_argument("--help-texts", metavar="BRINDLE", help="list long option texts of this tool")
    arguments = parser.parse_args()
    if arguments.help_texts:
        return list_help_texts(arguments.help_texts)
    paths = [path.resolve() for path in arguments.pages] or \
        [ROOT / name for name in PAGES] + sorted((ROOT / "docs").rglob("*.md"))
    names = [str(path.relative_to(ROOT)) for path in paths]
    texts = {name: (ROOT / name).read_text() for name in names if name not in GENERATED}
    findings = [f"{name}:{number}: {message}" for name, text in texts.items()
                for number, message in check_prose(text)]
    findings += check_budgets(texts)
    print("\n".join(findings) or f"{len(texts)} pages read well")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
