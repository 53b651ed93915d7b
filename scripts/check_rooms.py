#!/usr/bin/env python3
"""Compares the rooms that docs/architecture.md draws with the includes of the sources.

usage: check_rooms.py [ROOT]

The table whose first column is 'module' has, in a row per module, what is in it, its public headers and
the rooms that it may include, which stand for all that these may include, too. The README's program must be that of tests/consumer. Fails if a file
includes what its room may not, if a room, a public header or a permission is missing from the
table, or if the table has one that the sources do not. The table of the tool's rooms, in apps/brindle,
is checked in the same way, and so is the one of programs: whose private headers of the library they may include.
"""
import pathlib
import re
import sys

UMBRELLAS = ('brindle', 'pictures', 'gpu', 'ranks', 'requests')  # headers of other headers alone
INCLUDE = re.compile(r'^\s*#\s*include "brindle/([^"]+)"', re.MULTILINE)


def words(cell):
    return re.findall(r'`([a-z_0-9]+)`', cell)


def paths(cell):
    return re.findall(r'`([a-z/]+)`', cell)


def read_table(text):
    rooms = {}
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip().strip('|').split('|')]
        if len(cells) == 4 and re.fullmatch(r'`[a-z]+`', cells[0]):
            rooms[words(cells[0])[0]] = {'public': words(cells[2]), 'may': words(cells[3])}
    return rooms


def reachable(rooms, room):
    found, todo = set(), [room]
    while todo:
        for other in rooms[todo.pop()]['may']:
            if other not in found:
                found.add(other)
                todo.append(other)
    return found


def check(root):
    complaints = []
    rooms = read_table((root / 'docs/architecture.md').read_text())
    folders = {p.name for p in (root / 'src/brindle').iterdir() if p.is_dir()}
    for name in sorted(folders ^ rooms.keys()):
        complaints.append(f"room '{name}' is in {'the sources' if name in folders else 'the table'} alone")
    rooms = {name: room for name, room in rooms.items() if name in folders}
    for name, room in rooms.items():
        for other in room['may']:
            if other not in rooms:
                complaints.append(f"'{name}' may include '{other}', which is no room")
        room['may'] = [other for other in room['may'] if other in rooms]
    room_of = {header: name for name, room in rooms.items() for header in room['public']}
    public = {p.stem for p in (root / 'include/brindle').glob('*.h')} - set(UMBRELLAS)
    for header in sorted(public ^ room_of.keys()):
        complaints.append(f"public header '{header}' is in {'include' if header in public else 'the table'} alone")

    files = [(p, p.relative_to(root / 'src/brindle').parts[0])
             for p in (root / 'src/brindle').glob('*/**/*.[hc]*') if p.suffix in ('.h', '.cpp')]
    files += [(p, room_of.get(p.stem)) for p in (root / 'include/brindle').glob('*.h')]

    def room_of_include(target):
        parts = target.removesuffix('.h').split('/')
        return parts[0] if len(parts) > 1 else room_of.get(parts[0])

    return complaints + check_arrows(root, rooms, files, INCLUDE, room_of_include)


def check_arrows(root, rooms, files, include, room_of_include):
    """Of files with their rooms, whose includes `include` finds."""
    complaints = []
    used = {name: set() for name in rooms}
    for path, room in files:
        if room not in rooms:
            continue
        for target in include.findall(path.read_text()):
            other = room_of_include(target)
            if other not in rooms or other == room:
                continue
            used[room].add(other)
            if other not in reachable(rooms, room):
                complaints.append(f"{path.relative_to(root)} ({room}) includes {target} ({other})")
    for name, room in rooms.items():
        if name in reachable(rooms, name):
            complaints.append(f"'{name}' can be reached from itself")
        complaints += [f"'{name}' may include '{other}' but does not"
                       for other in room['may'] if other not in used[name]]
    return complaints


TOOL_INCLUDE = re.compile(r'^\s*#\s*include "((?:[a-z]+/)+[a-z_0-9]+)\.h"', re.MULTILINE)


def read_tool_table(text):
    rooms = {}
    section = text[text.index('\n## The tool'):]
    for line in section[:section.index('\n### ')].splitlines():
        cells = [cell.strip() for cell in line.strip().strip('|').split('|')]
        if len(cells) == 3 and re.fullmatch(r'`[a-z/]+`', cells[0]):
            rooms[paths(cells[0])[0]] = {'may': paths(cells[2])}
    return rooms


def check_tool(root):
    """The rooms of apps/brindle, and those in them, whose includes name the room."""
    rooms = read_tool_table((root / 'docs/architecture.md').read_text())
    folder = root / 'apps/brindle'
    room_of = lambda path: path.parent.relative_to(folder).as_posix()
    files = [(path, room_of(path)) for path in folder.glob('*/**/*.[hc]*')]
    folders = {room for _, room in files}
    complaints = [f"room '{name}' of the tool is in {'the sources' if name in folders else 'the table'} alone"
                  for name in sorted(folders ^ rooms.keys())]
    rooms = {name: room for name, room in rooms.items() if name in folders}
    complaints += [f'{path.relative_to(root)} is in no room' for path in folder.glob('*.cpp')
                   if path.name != 'main.cpp']
    return complaints + check_arrows(root, rooms, files, TOOL_INCLUDE, lambda target: target.rpartition('/')[0])


PRIVATE_INCLUDE = re.compile(r'^\s*#\s*include [<"]brindle/([a-z_]+)/(?:[a-z_]+/)*([a-z_0-9]+)\.h[>"]',
                             re.MULTILINE)


def read_programs(text):
    """Folders of programs, and the rooms whose private headers they may include."""
    section = text[text.index('\n| program |'):]
    section = section[:section.index('\n\n')]
    rows = re.findall(r'^\| `([a-z_/]+)` \| ([^|]*)\|$', section, re.MULTILINE)
    return {folder: words(rooms) for folder, rooms in rows}


def check_programs(root):
    complaints = []
    programs = read_programs((root / 'docs/architecture.md').read_text())
    used = {folder: set() for folder in programs}
    for path in [p for top in ('apps', 'bench', 'c', 'python', 'paraview', 'web') for p in (root / top).glob('**/*.[hc]*')]:
        name = path.relative_to(root).as_posix()
        if name.startswith(('paraview/tests/', 'web/node_modules/')):
            continue
        folder = max((f for f in programs if name.startswith(f + '/')), key=len, default=None)
        if folder is None:
            complaints.append(f'{name} is of no program that the table has')
            continue
        for room, header in PRIVATE_INCLUDE.findall(path.read_text()):
            if header == 'parsed_words':
                continue
            used[folder].add(room)
            if room not in programs[folder]:
                complaints.append(f'{name} includes {header}.h, which is private to {room}')
    complaints += [f"'{folder}' may include private headers of '{room}' but does not"
                   for folder, rooms in programs.items() for room in rooms if room not in used[folder]]
    return complaints


def check_program(root):
    program = (root / 'tests/consumer/main.cpp').read_text()
    if f'```cpp\n{program}```' in (root / 'README.md').read_text():
        return []
    return ['the program in README.md is not tests/consumer/main.cpp']


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else '.').resolve()
    complaints = check(root) + check_tool(root) + check_programs(root) + check_program(root)
    print('\n'.join(complaints) or 'the rooms are as drawn')
    return 1 if complaints else 0


if __name__ == '__main__':
    sys.exit(main())
