# SPDX-License-Identifier: MIT
"""What a student has reached: the last verdict on each lab, the lab in hand, the hints that were given.

Kept in build/progress.json. It is a memory, no more: where it is lost, ./lab check finds out again."""

import hashlib
import json
from typing import Any

import labs
import whole
from labs import ROOT, Lab

FILE = ROOT / "build" / "progress.json"


def load() -> dict[str, Any]:
    """What is remembered; nothing where there is no file, or none that can be read."""
    try:
        known = json.loads(FILE.read_text(encoding="utf-8"))
        return known if isinstance(known, dict) else {}
    except (OSError, ValueError):
        return {}


def save(known: dict[str, Any]) -> None:
    """Whole or not at all: two commands may write at a time."""
    FILE.parent.mkdir(exist_ok=True)
    whole.write(FILE, json.dumps(known, indent=1))


def fingerprint(lab: Lab) -> str:
    """Of the student's header as it is now; empty where it is not there."""
    try:
        return hashlib.sha256(lab.student_file.read_bytes()).hexdigest()
    except OSError:
        return ""


def remember(lab: Lab, passed: list[bool]) -> None:
    """A verdict on the header as it is now."""
    known = load()
    entry = known.setdefault(lab.number, {})
    entry["passed"], entry["header"] = passed, fingerprint(lab)
    known["current"] = lab.number
    save(known)


def forget(lab: Lab) -> None:
    """The lab begins anew: no step passes, and no hint was given."""
    known = load()
    known.pop(lab.number, None)
    known["current"] = lab.number
    save(known)


def passed(lab: Lab, known: dict[str, Any]) -> list[bool]:
    """Step by step, as of the last verdict."""
    steps = known.get(lab.number, {}).get("passed", [])
    return steps if len(steps) == len(lab.steps) else [False] * len(lab.steps)


def changed_since(lab: Lab, known: dict[str, Any]) -> bool:
    """Whether the header is another one than the last verdict was about; before any verdict: whether it was written on."""
    before = known.get(lab.number, {}).get("header")
    return fingerprint(lab) != before if before else begun(lab)


def begun(lab: Lab) -> bool:
    """Whether the header is no longer the starter."""
    try:
        text = lab.student_file.read_text(encoding="utf-8", errors="replace")
        return text != lab.starter()
    except (OSError, labs.Problem):
        return labs.differs_from_commit(lab.student_file)


def current(known: dict[str, Any]) -> Lab | None:
    """The lab in hand: the one asked for last, unless it is done; else the first that is not done."""
    everything = labs.all_labs()
    last = next((lab for lab in everything if lab.number == known.get("current")), None)
    if last is not None and not all(passed(last, known)):
        return last
    return next((lab for lab in everything if not all(passed(lab, known))), None)


def next_hint(lab: Lab, step: int, levels: int) -> int:
    """Which hint comes next for a step, from 1; the last one again when all were given. Remembers that it was given."""
    known = load()
    given = known.setdefault(lab.number, {}).setdefault("hints", {})
    level = min(given.get(str(step), 0) + 1, levels)
    given[str(step)] = level
    known["current"] = lab.number
    save(known)
    return level
