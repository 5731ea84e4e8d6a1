# SPDX-License-Identifier: MIT
"""Error against run time, measured and drawn: out/report/index.html; a student's samplers beside ours, or those of a whole course."""

import argparse
import os
import pathlib
import sys
import time
from concurrent.futures import ThreadPoolExecutor, as_completed

import callgrind
import machine
import process
import project
from labs import Lab, Problem
from process import ROOT
from reporting import digest, page, pieces, students

try:
    from reporting import submissions
except ImportError:  # a students' copy: it grades nobody
    submissions = None

SUMMARY = "error against run time, as a page: out/report/index.html"
USAGE = "report [--quick] [--lab NN (--student | --submissions FOLDER)] [--out DIR]"

FULL = {"trials": 16, "most": 4096, "renderings": 20000, "triangles": 50000, "seed": 0}
QUICK = {"trials": 8, "most": 256, "renderings": 2000, "triangles": 5000, "seed": 0}


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("--quick", action="store_true", help="fewer samples and trials: a look at the page, not at the figures")
    parser.add_argument("--lab", action="append", default=[], metavar="NN", help="measure the samplers of this lab, too: 04 or 13; may be given twice")
    parser.add_argument("--student", action="store_true", help="those of your own header, beside ours")
    parser.add_argument("--solution", action="store_true", help="those of the solution")
    if submissions:
        parser.add_argument("--submissions", type=pathlib.Path, metavar="FOLDER",
                            help="those of all that was handed in: a folder, an archive or a header for each student, run in the sandbox of ./lab grade")
        parser.add_argument("--trust", action="store_true", help="go on where no sandbox can be had: the submissions then may do what you may do")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "report", help="the folder to write to")
    parser.add_argument("--seed", type=int, default=0, help="the first seed; another one gives other random numbers throughout")
    parser.add_argument("--trials", type=int, help="renderings with different seeds (default: 16, or 8 with --quick)")
    parser.add_argument("--most", type=int, help="samples a pixel, at most (default: 4096, or 256 with --quick)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 2, help="programs at a time (default: one a core)")
    wish = parser.parse_args(arguments)
    handed_in = getattr(wish, "submissions", None)
    labs = labs_wished(wish, handed_in)
    settings = {**(QUICK if wish.quick else FULL), "seed": wish.seed}
    settings.update({name: value for name in ("trials", "most") if (value := getattr(wish, name)) is not None})
    for name, value, least in (("seed", wish.seed, 0), ("jobs", wish.jobs, 1), ("trials", settings["trials"], 2), ("most", settings["most"], 256)):
        if value < least:
            raise process.Misuse(f"--{name} is {value}, but must be at least {least}")
    began = time.monotonic()

    machine.ensure("report")
    if labs:
        machine.ensure("grade" if handed_in else "test")
    drawer = machine.plotter()
    if drawer is None:
        raise Problem("no Python with matplotlib is here, which draws the plots: install python3-matplotlib and try again")
    folder = project.configure("release", tests=not wish.quick or bool(labs))
    settings["tests"] = pieces.built_tests(folder) if wish.quick else [name for name in pieces.TESTS if project.has_target(folder, name)]
    project.build(folder, "bench_convergence", "bench_ladder", "bench_trace", *settings["tests"])
    settings["valgrind"] = callgrind.works()
    if not settings["valgrind"]:
        print("valgrind is not here, or does not know this processor: the report goes without instruction counts")

    pictures = wish.out / "pictures"
    pictures.mkdir(parents=True, exist_ok=True)
    store = pieces.Store(wish.out / "measured")
    answers = measure_all(pieces.plan(settings, folder, pictures), store, wish.jobs)
    own, everyone = [], []
    for lab in labs:
        course = students.Course(lab, folder, settings, store)
        if handed_in:
            everyone += submissions.all_of(course, handed_in, wish.jobs, wish.trust)
        else:
            own.append(students.own(course, wish.solution, lambda what: print(f"lab {course.lab.number}: {what}", flush=True)))

    report = digest.digest(answers, settings, pieces.environment(folder), own, everyone)
    page.write(report, wish.out, drawer)
    print(f"\nDone in {time.monotonic() - began:.0f} s: {process.shorten(str(wish.out / 'index.html'))}, report.csv, prices.csv, report.json")
    for line in digest.complaints(report):
        print(f"  look at this: {line}")
    for entry in report["own"]:
        print(f"\nLab {entry['lab']}, {entry['title']}: {entry['message'] or entry['headline']}")
        for one in entry["curves"]:
            print(f"  {one['effect']}, {one['pattern']}: {one['sentence']}")
    for entry in report["submissions"]:
        if entry["outlier"]:
            print(f"  look at this: {entry['name']}: {entry['headline']}")
    return 0


def labs_wished(wish: argparse.Namespace, handed_in: pathlib.Path | None) -> list[Lab]:
    whose = [name for name, is_so in (("student", wish.student), ("solution", wish.solution), ("submissions", handed_in)) if is_so]
    if len(whose) > 1:
        raise process.Misuse(f"--{whose[0]} and --{whose[1]}: one of them")
    if bool(wish.lab) != bool(whose):
        raise process.Misuse("--lab says which lab, and --student, --solution or --submissions FOLDER whose: both are needed, or neither")
    if handed_in and len(wish.lab) > 1:
        raise process.Misuse("--submissions are those of one lab")
    if handed_in and not handed_in.is_dir():
        raise Problem(f"{handed_in} is no folder")
    return [students.lab_named(word) for word in dict.fromkeys(wish.lab)]


def measure_all(plan: list[pieces.Piece], store: pieces.Store, jobs: int) -> dict[str, object]:
    """All answers by the pieces' names. What is stored is not measured again; Ctrl-C loses the pieces under way alone."""
    answers = {piece.name: answer for piece in plan if (answer := store.get(piece)) is not None}
    todo = [piece for piece in plan if piece.name not in answers]
    if answers and todo:
        print(f"{len(answers)} of {len(plan)} measurements are there already: going on")
    whole = sum(piece.seconds for piece in plan)
    done = whole - sum(piece.seconds for piece in todo)
    began = time.monotonic()
    start = done
    with ThreadPoolExecutor(jobs) as pool:
        running = {pool.submit(pieces.measure, piece, store): piece for piece in todo}
        try:
            for future in as_completed(running):
                piece = running[future]
                answers[piece.name] = future.result()
                done += piece.seconds
                left = (time.monotonic() - began) * (whole - done) / max(done - start, 1e-9)
                progress(done / whole, left, piece.name)
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
    return answers


def progress(fraction: float, seconds_left: float, what: str) -> None:
    """A bar where there is a terminal, else a line now and then."""
    if sys.stdout.isatty():
        width = 30
        bar = "#" * round(fraction * width)
        end = "\n" if fraction >= 1 - 1e-9 else ""
        print(f"\r\033[K[{bar:<{width}}] {100 * fraction:3.0f} %, about {seconds_left:.0f} s left: {what[:40]}", end=end, flush=True)
    else:
        print(f"{100 * fraction:3.0f} %  {what}", flush=True)
