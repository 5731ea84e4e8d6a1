# SPDX-License-Identifier: MIT
"""What a lab's steps are worth: labs/labNN_topic/grading.json, or what holds where there is none."""

import json
from dataclasses import dataclass, field

from labs import ROOT, Lab, Problem

VISIBILITIES = ("visible", "hidden", "after_due_date", "after_published")
POINTS_PER_STEP = 10


@dataclass
class StepScheme:
    points: float = POINTS_PER_STEP
    partial: float = 0.0         # the part of the points that its tests share when not all of them hold
    visibility: str = "visible"  # of its public tests
    hidden: str = "visible"      # of its hidden tests, which show no more than their names


@dataclass
class Scheme:
    steps: list[StepScheme]
    macros: bool = False         # whether a header may leave macros behind
    call: float = 10             # limits of the student's code, in seconds
    case: float = 30
    step: float = 60
    title: str = field(default="")

    @property
    def total(self) -> float:
        return sum(step.points for step in self.steps)


@dataclass
class Mark:
    """A test, passed or not, and whether it is a hidden one."""
    name: str
    passed: bool
    hidden: bool = False


def score(step: StepScheme, marks: list[Mark]) -> float:
    """All points when all tests hold. Else `partial` of them, by the part of the tests that hold; the hidden tests of a
    step weigh as much as its public ones together, so who knows the public answers by heart gets half of that at most."""
    if marks and all(mark.passed for mark in marks):
        return step.points
    parts = [[mark.passed for mark in marks if mark.hidden == hidden] for hidden in (False, True)]
    shares = [sum(part) / len(part) for part in parts if part]
    if not shares or step.partial <= 0:
        return 0.0
    return round(step.points * step.partial * sum(shares) / len(shares), 2)


def read(lab: Lab) -> Scheme:
    path = ROOT / "labs" / lab.folder / "grading.json"
    if not path.exists():
        return Scheme([StepScheme() for _ in lab.steps])
    try:
        return parse(json.loads(path.read_text(encoding="utf-8")), lab)
    except ValueError as problem:
        raise Problem(f"{path.relative_to(ROOT)}: {problem}") from None


def parse(said: dict, lab: Lab) -> Scheme:
    """ValueError, naming what is wrong, for whatever is not as docs/instructors.md has it."""
    unknown = set(said) - {"steps", "macros", "seconds"}
    if unknown:
        raise ValueError(f"unknown: {', '.join(sorted(unknown))}")
    steps = said.get("steps", [{} for _ in lab.steps])
    if len(steps) != len(lab.steps):
        raise ValueError(f"{len(steps)} steps, but the lab has {len(lab.steps)}")
    made = []
    for number, step in enumerate(steps, 1):
        unknown = set(step) - set(StepScheme.__dataclass_fields__)
        if unknown:
            raise ValueError(f"step {number}, unknown: {', '.join(sorted(unknown))}")
        one = StepScheme(**step)
        if not (isinstance(one.points, (int, float)) and one.points >= 0):
            raise ValueError(f"step {number}: points are a number from 0 on")
        if not (isinstance(one.partial, (int, float)) and 0 <= one.partial <= 1):
            raise ValueError(f"step {number}: partial is a number from 0 to 1")
        if one.visibility not in VISIBILITIES or one.hidden not in VISIBILITIES:
            raise ValueError(f"step {number}: visibility and hidden are one of {', '.join(VISIBILITIES)}")
        made.append(one)
    seconds = said.get("seconds", {})
    if set(seconds) - {"call", "case", "step"} or not all(isinstance(each, (int, float)) and each > 0 for each in seconds.values()):
        raise ValueError("seconds are numbers above 0 for call, case and step")
    if said.get("macros", "refuse") not in ("refuse", "allow"):
        raise ValueError("macros is refuse or allow")
    return Scheme(made, said.get("macros") == "allow", **seconds)
