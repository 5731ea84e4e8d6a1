# SPDX-License-Identifier: MIT
"""The samplers of a whole course, none of which is trusted: compiled and run in the sandbox of ./lab grade, measured outside of it."""

import json
import os
import pathlib
import shutil
import tempfile
from typing import Any

import student
from grading import archive, kit, submission, term
from grading.overview import cell
from grading.sandbox import MIB, Limits, Sandbox
from labs import ROOT, Lab, Problem
from reporting import judgement, points, students


def limits() -> Limits:
    return Limits(cpu=points.CPU, memory=1024 * MIB, processes=8, file_size=4 * MIB)


class Kit:
    """What a submission is compiled with, in the sandbox, under the names that grading has for it, too."""

    def __init__(self, lab: Lab, stage: pathlib.Path, tree: pathlib.Path, trust: bool):
        self.lab = lab
        self.level = kit.isolation(lab, tree, trust)
        self.folder = stage / "kit"
        self.folder.mkdir()
        commands = json.loads((tree / "compile_commands.json").read_text(encoding="utf-8"))
        self.compiler = kit.options_of(commands, f"{lab.name}_points.dir/", tree, self.folder)
        for name, files in (("points", [ROOT / "bench" / "points" / each for each in ("write.hpp", f"{lab.name}_bind.cpp")]),
                            ("include/lantern", (tree / "labs" / lab.name / "program" / "lantern").glob("*.hpp"))):
            (self.folder / name).mkdir(parents=True)
            for file in files:
                shutil.copyfile(file, self.folder / name / file.name)
        self.digest = kit.digest_of([path for path in sorted(self.folder.rglob("*")) if path.is_file()], json.dumps(self.compiler))
        for path in (self.folder, *self.folder.rglob("*")):
            os.chmod(path, 0o755 if path.is_dir() else 0o644)

    @property
    def seen(self) -> dict[str, pathlib.Path]:
        return {kit.KIT: self.folder}

    def command(self) -> list[str]:
        return [*self.compiler, f"-I{kit.CODE}", f"-I{kit.KIT}/include", f"{kit.KIT}/points/{self.lab.name}_bind.cpp", "-o", f"{kit.OUT}/points"]


def measured(course: students.Course, made: Kit, one: term.Student, box: Sandbox) -> dict:
    """One submission: compiled and run in the sandbox, measured outside of it."""
    entry: dict[str, Any] = {"name": one.name, "cell": cell(one.name), "lab": course.lab.number, "title": course.lab.title, "message": "", "curves": []}
    try:
        files, where = archive.placed(archive.read(one.path), course.lab)
    except archive.Refused as refused:
        return entry | {"message": str(refused)}
    entry["header"] = archive.plain(where)
    identity = f"{made.digest}-{submission.digest(files)}"
    with tempfile.TemporaryDirectory(prefix="student-", dir=made.folder.parent) as name:
        folder = pathlib.Path(name)
        os.chmod(folder, 0o711)
        submission.laid_out(files, folder / "code")
        status, printed = submission.compile_in(box, made.command(), kit.COMPILING, made, folder, box.own(folder / "out"))
        if status != 0:
            return entry | {"message": submission.explained(made, printed, status)}
        program = submission.taken(folder / "out" / "points", folder / "points")
        try:
            curves = course.all_of(box.command(["/points"], limits(), readable={"/points": program}), identity)
        finally:
            box.end_all()
    for one_curve in curves:  # what a stranger's program says is shown on a page, and in a terminal
        one_curve["end"]["says"] = archive.plain(one_curve["end"]["says"])
    return entry | {"curves": curves}


def all_of(course: students.Course, folder: pathlib.Path, jobs: int, trust: bool) -> list[dict]:
    everyone = term.students(folder)
    if not everyone:
        raise Problem(f"there are no submissions in {folder}")
    found: dict[int, dict] = {}
    tree = student.set_up()
    good, output = student.build(tree, "lantern_probe")
    if not good:
        raise Problem(f"the sandbox's probe does not build:\n{student.first_error(output)}")
    with kit.stage_folder() as stage, term.Slots(jobs) as slots:
        made = Kit(course.lab, pathlib.Path(stage), tree, trust)
        print(f"The sandbox is {made.level}")
        progress = term.Progress(len(everyone), f"lab {course.lab.number}")

        def done(i: int, entry: dict) -> None:
            found[i] = entry
            progress.step(f"{everyone[i].name}: {judgement.in_short(entry)}")

        term.run_all([lambda one=one: slots.use(lambda box: measured(course, made, one, box)) for one in everyone], jobs, done)
    return [found[i] for i in range(len(everyone))]
