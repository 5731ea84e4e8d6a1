# SPDX-License-Identifier: MIT
"""Samplers that students wrote, measured as ours are. Those of a whole course are in submissions.py."""

import hashlib
import json
import pathlib
from typing import Callable

import process
import student
from labs import ROOT, Lab, Problem
from reporting import pieces, points

# The labs that hold a sampler. Each of its patterns, and that of ours which it is to be compared with.
LABS = {"04": {"jittered": "jittered", "N-rooks": "N-rooks", "multi-jittered": "multi-jittered"},
        "13": {"cells and strata": "jittered"}}
ANY_NUMBER = {"13"}  # takes numbers of samples that are no squares
ONE_NUMBER = {"13"}  # makes points for what takes one number, too


def lab_named(word: str) -> Lab:
    lab = student.lab_named(word)
    if lab.number not in LABS:
        raise process.Misuse(f"lab {lab.number} has no sampler to measure; these have: {', '.join(LABS)}")
    return lab


def counts(lab: str, most: int) -> list[int]:
    """Numbers of samples: ours, and for who can do any number those between, 10, 40, 160 …"""
    ours = [4 ** k for k in range(1, 17) if 4 ** k <= most]
    between = [10 * 4 ** k for k in range(16) if 10 * 4 ** k <= most]
    return sorted(ours + between) if lab in ANY_NUMBER else ours


class Course:
    """What a sampler is measured with: the pictures, the effort, and what ours did there."""

    def __init__(self, lab: Lab, tree: pathlib.Path, settings: dict, store: pieces.Store):
        self.lab, self.settings, self.store = lab, settings, store
        self.convergence = str(tree / "bench" / "convergence")
        code, text = process.capture([self.convergence, "--list"])
        if code != 0:
            raise Problem(f"the list of pictures cannot be had:\n{text}")
        self.pictures = [one for one in json.loads(text) if one["dimensions"] > 1 or lab.number in ONE_NUMBER]

    def tasks(self) -> list[tuple[str, dict]]:
        return [(pattern, picture) for pattern in LABS[self.lab.number] for picture in self.pictures]

    def measure(self, pattern: str, picture: dict, maker: list[str], identity: str) -> dict:
        """The answer of `points.measured`, stored; not where time ran out, since that may be the machine's."""
        numbers = ",".join(map(str, counts(self.lab.number, self.settings["most"])))
        wish = ["--trials", str(self.settings["trials"]), "--first", str(self.settings["seed"]), "--counts", numbers]
        one = "1" if picture["dimensions"] == 1 else "2"
        options = ["--pattern", pattern, "--purposes", ",".join(map(str, picture["purposes"])), "--numbers", one, "--width", "24", "--height", "16", *wish]
        measuring = [self.convergence, "--json", "--points", "--effect", picture["effect"], "--sampler", pattern, "--threads", "1",
                     "--width", "24", "--height", "16", *wish]
        piece = pieces.Piece("students", f"{identity}, {pattern}, {picture['effect']}", measuring, follows=identity + " ".join(options))
        answer = self.store.get(piece)
        if answer is None:
            answer = points.measured(maker, options, measuring)
            if answer["end"]["kind"] != "time":
                self.store.put(piece, answer)
        return answer

    def all_of(self, maker: list[str], identity: str, step: Callable[[str], None] = lambda _: None) -> list[dict]:
        """All patterns in all pictures. After one that did not end in time no more are tried of that pattern."""
        found: list[dict] = []
        lost: set[str] = set()
        for pattern, picture in self.tasks():
            if pattern not in lost:
                step(f"{pattern}, {picture['effect']}")
                answer = self.measure(pattern, picture, maker, identity)
                found.append({"pattern": pattern, "effect": picture["effect"], "beside": LABS[self.lab.number][pattern], **answer})
                if answer["end"]["kind"] == "time":
                    lost.add(pattern)
        return found


def own(course: Course, solution: bool, step: Callable[[str], None]) -> dict:
    """The student's header in this checkout. What is wrong with it is part of the answer."""
    entry = {"name": "your" if not solution else "the solution's", "lab": course.lab.number, "title": course.lab.title,
             "header": str((course.lab.solution_file if solution else course.lab.student_file).relative_to(ROOT)), "message": "", "curves": []}
    try:
        program = student.built(course.lab, "_points", solution)
    except student.NotYet as problem:
        return entry | {"message": str(problem)}
    identity = hashlib.sha256(program.read_bytes()).hexdigest()[:16]
    return entry | {"curves": course.all_of(points.limited(str(program)), identity, step)}
