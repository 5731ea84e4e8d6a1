# SPDX-License-Identifier: MIT
"""A lab's explain program, asked: built with the student's header, run with a limit, its answer read."""

import json
import os
import pathlib
import subprocess
import tempfile
from dataclasses import dataclass

import process
import student
import verdict
from labs import ROOT, Lab, Problem

# Why some labs have no such program.
NOTHING = {
    "lab01": "a pixel there is one ray, and its colour is the ray's direction; no ray meets a surface yet",
    "lab04": "its pictures are made of points and filters, and no ray is sent for them",
    "lab13": "its pictures are curves and closed forms, and no ray meets a surface for them",
    "lab14": "its pictures show formulas one by one; ./lab run 14 prints what each gets wrong, ./lab stress --student says it case by case",
    "lab15": "its tracer is put together from parts of the other labs; explain the lab that a part comes from",
}


@dataclass
class Picture:
    name: str
    width: int
    height: int


class Explainer:
    """Raises student.NotYet where the student's file has to be mended first."""

    def __init__(self, lab: Lab, solution: bool):
        self.lab = lab
        if not (ROOT / "labs" / lab.folder / "explain.cpp").is_file():
            raise Problem(f"in lab {lab.number} there is nothing to explain: {NOTHING.get(lab.name, 'it has no explain.cpp')}")
        self.program = student.built(lab, "_explain", solution)
        self.pictures = [Picture(**one) for one in self.ask("list")]

    def picture(self, name: str | None) -> Picture:
        """The first one is the one that is meant when none is named; a part of the name will do."""
        if name is None:
            return self.pictures[0]
        found = [one for one in self.pictures if name == one.name] or [one for one in self.pictures if name in one.name]
        if len(found) != 1:
            raise process.Misuse(f"there is no picture '{name}' of lab {self.lab.number}'s to explain; these are: {', '.join(one.name for one in self.pictures)}"
                                 if not found else f"'{name}' may be {' or '.join(one.name for one in found)}")
        return found[0]

    def ask(self, *words: str, patience: float = 1):
        """What the program answers; the limit is that of one step of ./lab check, `patience` times."""
        limit = patience * float(os.environ.get("LANTERN_STEP_SECONDS", verdict.SECONDS_PER_STEP))
        look = f"./lab check {self.lab.number} looks at each step by itself."
        with tempfile.TemporaryDirectory(prefix="lantern-") as folder:
            answer = pathlib.Path(folder) / "answer.json"
            with open(pathlib.Path(folder) / "printed", "w+b") as printed:
                child = subprocess.Popen([str(self.program), *words, str(answer)], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                         stderr=printed, cwd=folder, start_new_session=True)
                try:
                    status = child.wait(limit)
                except subprocess.TimeoutExpired:
                    status = None
                finally:
                    verdict.stop(child)
                printed.seek(0)
                said = printed.read(2000).decode(errors="replace").strip()
            if status is None:
                raise student.NotYet(f"Your code did not finish in {limit:g} s: an endless loop? {look}")
            if status < 0:
                raise student.NotYet(f"Your code crashed ({verdict.signal_name(-status)}). {look}")
            if status != 0 or not answer.is_file():
                raise student.NotYet(f"Your code ended the program (exit status {status}){': ' + said if said else ''}. {look}")
            told = json.loads(answer.read_text(encoding="utf-8", errors="replace"))
        if "gap" in told:
            gap = told["gap"].removeprefix(f"{self.lab.name} ")
            raise student.NotYet(f"This waits for what is still to be written: {gap}.\nThe handout is labs/{self.lab.folder}/README.md, "
                                 f"your file labs/{self.lab.folder}/{self.lab.header}")
        return told["answer"]


def pixel(text: str, picture: Picture) -> tuple[int, int]:
    """120,45 as two numbers, both within the picture."""
    try:
        x, y = (int(word) for word in text.split(","))
    except ValueError:
        raise process.Misuse(f"--pixel takes two whole numbers such as 120,45; '{text}' is none") from None
    if not (0 <= x < picture.width and 0 <= y < picture.height):
        raise process.Misuse(f"pixel {x},{y} is not in {picture.name}, which has {picture.width} × {picture.height} pixels: x goes from 0 to {picture.width - 1}, "
                             f"from left to right, and y from 0 to {picture.height - 1}, from the top down")
    return x, y


def srgb(linear: float) -> int:
    """IEC 61966-2-1, as the pictures are written."""
    x = min(max(linear or 0, 0), 1)
    encoded = 12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055
    return int(255 * encoded + 0.5)
