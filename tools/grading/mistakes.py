# SPDX-License-Identifier: MIT
"""Which mistake a student made: the tests that fail, matched to those that each of the lab's mutants fails."""

import json
import pathlib
from typing import Callable

import labs
from grading.kit import Kit, digest_of

Pattern = frozenset[str]


def patterns(kit: Kit, cache: pathlib.Path, grade_all: Callable[[list[dict[str, bytes]]], list[dict]]) -> dict[str, Pattern]:
    """The tests that each mutant fails, found by grading it. Kept in `cache` until the lab changes."""
    mutants = kit.lab.mutants()
    key = kit.digest + digest_of([kit.lab.solution_file, *sorted((kit.lab.tests / "mutants").glob("*.mutant"))])
    try:
        kept = json.loads(cache.read_text(encoding="utf-8"))
        if kept["key"] == key:
            return {name: frozenset(failed) for name, failed in kept["patterns"].items()}
    except (OSError, ValueError, KeyError):
        pass
    solution = kit.lab.solution_file.read_text(encoding="utf-8")
    results = grade_all([{f"{kit.lab.folder}/{kit.lab.header}": labs.mutate(solution, mutant).encode()} for mutant in mutants])
    found = {mutant.name: failures(result) for mutant, result in zip(mutants, results)}
    cache.parent.mkdir(parents=True, exist_ok=True)
    written = cache.with_suffix(".new")
    written.write_text(json.dumps({"key": key, "patterns": {name: sorted(failed) for name, failed in found.items()}}), encoding="utf-8")
    written.replace(cache)
    return found


def failures(result: dict) -> Pattern:
    """What fails, but for what is still to be written."""
    if result["status"] != "graded":
        return frozenset()
    return frozenset(test["name"] for step in result["steps"] for test in step["tests"] if not test["passed"] and not test.get("gap"))


def found_in(result: dict, known: dict[str, Pattern], who: dict[str, str]) -> list[dict]:
    """The mistakes that explain the failures: the mutant that explains most, then what is left. Several mutants may look alike."""
    left, mistakes = set(failures(result)), []
    while left:
        inside = [name for name, pattern in known.items() if pattern and pattern <= left]
        if not inside:
            break
        most = max(len(known[name]) for name in inside)
        alike = sorted(name for name in inside if len(known[name]) == most and known[name] == known[max(inside, key=lambda n: (len(known[n]), n))])
        mistakes.append({"name": " or ".join(alike[:3]), "who": " Or: ".join(who[name] for name in alike[:3]), "sure": len(alike) == 1})
        left -= known[alike[0]]
    if not mistakes and left:
        def likeness(name: str) -> float:
            return len(known[name] & left) / len(known[name] | left)
        best = max(known, key=likeness, default="")
        if best and likeness(best) >= 0.6:
            mistakes.append({"name": best, "who": who[best], "sure": False})
    return mistakes
