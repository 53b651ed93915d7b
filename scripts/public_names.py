#!/usr/bin/env python3
"""Lists the functions and types that public headers declare at namespace level.

usage: public_names.py

Writes docs/headers.md: all public headers, module by module in the order of docs/architecture.md.
"""
import pathlib
import re

from check_rooms import UMBRELLAS, read_table

ROOT = pathlib.Path(__file__).resolve().parent.parent
TITLES = {"gl": "OpenGL", "gpu": "GPU"}
INTRODUCTION = """# The headers

Programs include one of five headers, which stay: names in them change only with a new major version. The headers that
they include may be split or joined.

UMBRELLAS
This page lists the declarations of all public headers of [the library](library.md), module by module. Comments in the
headers describe parameters, results and errors; `./dev docs` makes a searchable reference of them
(`build/docs/html/index.html`).
"""

TYPE = re.compile(r"\s*(?:template\s*<[^>]*>\s*)?(?:struct|class|enum class|enum)\s+(?:BRINDLE_EXPORT\s+)?(\w+)")
FUNCTION = re.compile(r"\b([a-z]\w*)\s*\(")
NO_FUNCTION = re.compile(r"\s*(?:using|extern|friend|inline constexpr|constexpr)\b")


def functions_and_types(text):
    """Of a header's text, in its order, each once. Bodies are skipped by their braces."""
    text = re.sub(r"(?m)//.*|^\s*#.*$", "", text)
    functions, types, depth, seen = [], [], 0, ""
    for character in text:
        if character == "{":
            depth += 1
            if depth == 2 and (match := TYPE.match(seen)):
                types.append(match[1])
            elif depth == 2 and (match := FUNCTION.search(seen)):
                functions.append(match[1])
            if depth == 1:
                seen = ""
        elif character == "}":
            depth -= 1
            if depth == 1:
                seen = ""
        elif depth == 1:
            seen += character
            if character == ";":
                match = FUNCTION.search(seen)
                if match and not NO_FUNCTION.match(seen):
                    functions.append(match[1])
                seen = ""
    return list(dict.fromkeys(functions)), list(dict.fromkeys(types))


def purpose(text):
    """The first sentence of a header's comment."""
    words = []
    for line in text.splitlines():
        if not line.startswith("///") or line == "///":
            break
        words.append(line[3:].strip())
    sentence = re.split(r"(?<=[^.])\.(?: (?=[A-Z])|$)", " ".join(words))[0]
    return re.sub(r" \(docs/[^)]*\)$", "", sentence).replace("|", "\\|")


def row(name):
    text = (ROOT / f"include/brindle/{name}.h").read_text()
    cells = [purpose(text), *(", ".join(f"`{one}`" for one in names) for names in functions_and_types(text))]
    return f"| `{name}` | " + "".join(f"{cell} | " if cell else "| " for cell in cells).rstrip()


def included(name):
    text = (ROOT / f"include/brindle/{name}.h").read_text()
    return set(re.findall(r'#include "brindle/(\w+).h"', text))


def umbrella_list():
    """A line per umbrella header. Every other public header must be in one."""
    headers = {path.stem for path in (ROOT / "include/brindle").glob("*.h")}
    left_out = headers.difference(UMBRELLAS, *map(included, UMBRELLAS))
    if left_out:
        raise SystemExit(f"no umbrella header includes {', '.join(sorted(left_out))}")
    return "".join(f"- `brindle/{name}.h`: {purpose((ROOT / f'include/brindle/{name}.h').read_text())}\n"
                   for name in UMBRELLAS)


def page():
    """The text of docs/headers.md."""
    parts = [INTRODUCTION.replace("UMBRELLAS\n", umbrella_list() + "\n")]
    for room, columns in read_table((ROOT / "docs/architecture.md").read_text()).items():
        if columns["public"]:
            rows = "\n".join(row(name) for name in sorted(columns["public"]))
            parts.append(f"## {TITLES.get(room, room.capitalize())}\n\n"
                         "| header | purpose | functions | types |\n|---|---|---|---|\n" + rows + "\n")
    return "\n".join(parts)


if __name__ == "__main__":
    (ROOT / "docs/headers.md").write_text(page())
