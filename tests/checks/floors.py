# SPDX-License-Identifier: MIT
"""Is the house as cmake/floors.cmake says? Every header listed and there, and none that looks upward or in a circle."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADERS = ROOT / "include" / "lantern"
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def listed() -> dict[str, int]:
    """Every header's floor."""
    text = (ROOT / "cmake" / "floors.cmake").read_text(encoding="utf-8")
    floors = {}
    for number, names in re.findall(r"^set\(LANTERN_FLOOR_(\d)([^)]*)\)", text, re.MULTILINE):
        for name in names.split():
            if name in floors:
                sys.exit(f"cmake/floors.cmake: {name} is listed twice")
            floors[name] = int(number)
    return floors


def names_of(path: pathlib.Path) -> list[str]:
    """The headers of the library that a file includes itself."""
    return [name[len("lantern/"):-len(".hpp")] for name in INCLUDE.findall(path.read_text(encoding="utf-8"))
            if name.startswith("lantern/")]


def circle(includes: dict[str, list[str]]) -> list[str]:
    """One circle of includes, or nothing."""
    done: set[str] = set()

    def walk(name: str, path: list[str]) -> list[str]:
        if name in path:
            return path[path.index(name):] + [name]
        if name in done:
            return []
        for next_name in includes.get(name, []):
            if found := walk(next_name, path + [name]):
                return found
        done.add(name)
        return []

    return next((found for name in includes if (found := walk(name, []))), [])


def main() -> int:
    floors = listed()
    there = {path.stem for path in HEADERS.glob("*.hpp")}
    problems = [f"include/lantern/{name}.hpp is listed in cmake/floors.cmake, but there is no such file"
                for name in sorted(floors.keys() - there)]
    problems += [f"include/lantern/{name}.hpp stands on no floor: list it in cmake/floors.cmake"
                 for name in sorted(there - floors.keys())]
    includes = {name: names_of(HEADERS / f"{name}.hpp") for name in sorted(there)}
    for name, included in includes.items():
        text = (HEADERS / f"{name}.hpp").read_text(encoding="utf-8")
        if not re.match(r"// SPDX-License-Identifier: MIT\n#pragma once\n// \S", text):
            problems.append(f"{name}.hpp does not begin with its licence, #pragma once, and a sentence that says what it is for")
        for other in included:
            if floors.get(other, 0) > floors.get(name, 9):
                problems.append(f"{name}.hpp (floor {floors[name]}) includes {other}.hpp (floor {floors[other]}): that is upward")
        for path in INCLUDE.findall(text):
            if path in ("glm/glm.hpp", "iostream") or path.startswith("lab"):
                problems.append(f"{name}.hpp includes {path}, which the library does not use")
    if found := circle(includes):
        problems.append("a circle of includes: " + " -> ".join(found))
    print("\n".join(problems) or f"{len(there)} headers on {len(set(floors.values()))} floors")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
