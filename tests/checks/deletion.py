# SPDX-License-Identifier: MIT
"""Can this header be deleted, and does everything that does not name it still build?

deletion.py NAME...                 by the includes: whatever reaches the header must name it itself
deletion.py --build FOLDER NAME...  by the compiler: no source file in FOLDER/compile_commands.json that does not name
                                    the headers, itself or in the "..." that it includes, needs them. What FOLDER has
                                    built says so itself: Ninja keeps the list of all files that the compiler opened.
                                    What it has not is checked against a copy of include/ without them
"""

import argparse
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

from floors import HEADERS, ROOT, names_of

OWN = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def closure(names: list[str], includes: dict[str, list[str]]) -> set[str]:
    """The headers of the library that these reach."""
    reached: set[str] = set()
    todo = list(names)
    while todo:
        name = todo.pop()
        if name not in reached:
            reached.add(name)
            todo += includes.get(name, [])
    return reached


def named_by(source: pathlib.Path) -> set[str]:
    """The headers of the library that a program names, itself or in the files of its own that it includes."""
    own: set[pathlib.Path] = set()
    todo = [source]
    while todo:
        path = todo.pop().resolve()
        if path not in own and path.is_file():
            own.add(path)
            todo += [path.parent / name for name in OWN.findall(path.read_text(encoding="utf-8"))]
    return {name for path in own for name in names_of(path)}


def by_includes(deleted: str) -> list[str]:
    includes = {path.stem: names_of(path) for path in HEADERS.glob("*.hpp")}
    problems = []
    for folder in ("include", "examples", "tests", "labs", "solutions", "bench", "grading"):
        for path in sorted([*(ROOT / folder).rglob("*.hpp"), *(ROOT / folder).rglob("*.cpp")]):
            names = names_of(path)
            if path.stem != deleted and deleted not in names and deleted in closure(names, includes):
                way = next(name for name in names if deleted in closure([name], includes))
                problems.append(f"{path.relative_to(ROOT)} does not name {deleted}.hpp, but needs it for {way}.hpp")
    return problems


def opened_by(build: pathlib.Path) -> dict[str, set[str]]:
    """The files that the compiler opened for each object in the folder, as Ninja noted them; only what is up to date."""
    cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
    ninja = re.search(r"^CMAKE_MAKE_PROGRAM:\w+=(.*ninja.*)$", cache, re.MULTILINE)
    if not ninja:
        return {}  # another generator: nothing is known
    said = subprocess.run([ninja[1], "-C", str(build), "-t", "deps"], capture_output=True, text=True, check=False).stdout
    opened: dict[str, set[str]] = {}
    for block in re.split(r"\n\n", said):
        head, *files = block.strip().splitlines() or [""]
        if head.endswith("(VALID)"):
            opened[head.split(": #deps")[0]] = {file.strip() for file in files}
    return opened


def opens(deleted: list[str], target: str, opened: dict[str, set[str]]) -> bool:
    """Whether an object needed one of these headers, itself or in its precompiled header."""
    return any(file.endswith(f"lantern/{name}.hpp") for file in opened[target] for name in deleted) or \
        any(opens(deleted, file, opened) for file in opened[target] if file in opened)


def by_compiler(deleted: list[str], build: pathlib.Path) -> list[str]:
    all_commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    opened = opened_by(build)
    commands = {}
    for command in all_commands:  # one is enough for each file: one that was built, where there is one
        output = command["command"].partition(" -o ")[2].split(" ")[0]
        if command["file"] not in commands or output in opened:
            commands[command["file"]] = {**command, "output": output}
    with tempfile.TemporaryDirectory() as folder:
        pruned = pathlib.Path(folder) / "include"
        shutil.copytree(ROOT / "include", pruned)
        for name in deleted:
            (pruned / "lantern" / f"{name}.hpp").unlink()

        def check(command: dict) -> str | None:
            source = pathlib.Path(command["file"])
            if source.suffix != ".cpp" or not source.is_relative_to(ROOT) or set(deleted) & named_by(source):
                return None
            if not source.is_file():
                return None  # made by a build, which has not been asked for it
            if str(ROOT / "include") not in command["command"]:
                return None  # a lab's: it has the library by links, of the headers that its lab.json names
            if command["output"] in opened:
                return f"{source.relative_to(ROOT)} includes what it does not name" if opens(deleted, command["output"], opened) else None
            words = [word.replace(str(ROOT / "include"), str(pruned)) for word in shlex.split(command["command"])]
            if "-o" in words:
                at = words.index("-o")
                del words[at:at + 2]
            done = subprocess.run([*words, "-fsyntax-only"], cwd=command["directory"], capture_output=True, text=True, check=False)
            return None if done.returncode == 0 else f"{source.relative_to(ROOT)} no longer compiles:\n{done.stderr[:2000]}"

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            return [problem for problem in pool.map(check, commands.values()) if problem]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path)
    parser.add_argument("names", nargs="+")
    wish = parser.parse_args()
    problems = [problem for name in wish.names for problem in by_includes(name)]
    if wish.build:
        problems += by_compiler(wish.names, wish.build.resolve())
    print("\n".join(problems) or "nothing needs " + " or ".join(wish.names) + " that does not name it")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
