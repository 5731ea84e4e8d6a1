# SPDX-License-Identifier: MIT
"""Grades what students handed in, none of which is trusted."""

import os
import pathlib
import sys

import machine
import process
import student
from grading import kit, mistakes, submission, term
from labs import ROOT

SUMMARY = "grade many submissions, in a sandbox"
USAGE = "grade SUBMISSIONS --lab NN --out DIR"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("submissions", metavar="SUBMISSIONS", nargs="?", help="a folder that holds a folder, an archive or a header for each student")
    parser.add_argument("--lab", required=True, metavar="NN", help="the lab's number, such as 06")
    parser.add_argument("--out", metavar="DIR", help="where the marks go; a run that was killed goes on there")
    parser.add_argument("--one", action="store_true", help="SUBMISSIONS is itself the only submission")
    parser.add_argument("--prepare", action="store_true", help="only build what grading takes, and try it on the solution")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 2, help="how many at once (default: one for each processor)")
    parser.add_argument("--seed", type=int, help="of the hidden tests' inputs (default: a new one, written to DIR/run.json)")
    parser.add_argument("--no-pictures", action="store_true", help="do not build and run the lab's program with each header")
    parser.add_argument("--no-mistakes", action="store_true", help="do not match failures to the lab's mutants")
    parser.add_argument("--show-hidden", action="store_true", help="tell what hidden tests found, too: for your eyes, not for students")
    parser.add_argument("--trust", action="store_true", help="go on where no sandbox can be had: the code then may do what you may do")
    wish = parser.parse_args(arguments)
    if wish.jobs < 1:
        raise process.Misuse("--jobs must be 1 or more")

    if not wish.prepare and not (wish.submissions and wish.out):
        raise process.Misuse("SUBMISSIONS and --out are needed")

    lab = student.lab_named(wish.lab)
    machine.ensure("grade")
    everyone: list[term.Student] = []
    if wish.one:
        everyone = [term.Student("submission", "submission", pathlib.Path(wish.submissions))]
    elif not wish.prepare:
        everyone = term.students(pathlib.Path(wish.submissions))
    with kit.stage_folder() as stage, term.Slots(wish.jobs) as slots:
        made = kit.made(lab, pathlib.Path(stage), trust=wish.trust)
        made.show_hidden = wish.show_hidden
        print(f"The sandbox is {made.level}", file=sys.stderr)
        slots.use(lambda box: submission.verified(made, box))
        if wish.prepare:
            print(f"lab {lab.number} can be graded: the solution gets {made.scheme.total:g} points")
            return 0
        marks = term.Term(made, pathlib.Path(wish.out).resolve(), wish.seed, not wish.no_pictures)
        print(f"The solution gets full marks: {made.scheme.total:g} points. The seed of the hidden tests is {marks.seed}", file=sys.stderr)
        if not wish.no_mistakes:
            marks.known = known_mistakes(made, slots, wish.jobs)

        results: dict[str, dict] = {}
        progress = term.Progress(len(everyone), f"lab {lab.number}")

        def done(i: int, result: dict) -> None:
            results[everyone[i].folder] = result
            progress.step(f"{everyone[i].name}: {result['score']:g} of {result['of']:g}" + (f" ({result['status']})" if result["status"] != "graded" else ""))

        works = [lambda one=one: slots.use(lambda box: marks.grade(one, box)) for one in everyone]
        try:
            term.run_all(works, wish.jobs, done)
        finally:
            marks.write_class(everyone, results)
    failed = [one.name for one in everyone if results[one.folder]["status"] == "error"]
    for name in failed:
        print(f"{name} was not graded: {results[next(one.folder for one in everyone if one.name == name)]['message']}", file=sys.stderr)
    out = process.shorten(str(marks.out))
    print(f"{out}/overview.html\n{out}/gradebook.csv")
    return 1 if failed else 0


def known_mistakes(made: kit.Kit, slots: term.Slots, jobs: int) -> dict[str, mistakes.Pattern]:
    """What the lab's mutants fail, graded as students are, but for the pictures."""
    def grade_all(all_files: list[dict[str, bytes]]) -> list[dict]:
        results: dict[int, dict] = {}
        progress = term.Progress(len(all_files), "known mistakes")

        def done(i: int, result: dict) -> None:
            results[i] = result
            progress.step("")

        term.run_all([lambda files=files: slots.use(lambda box: submission.graded(made, files, box, seed=1)) for files in all_files], jobs, done)
        return [results[i] for i in range(len(all_files))]

    return mistakes.patterns(made, ROOT / "build" / "grading" / f"{made.lab.name}-mistakes.json", grade_all)
