# SPDX-License-Identifier: MIT
"""Error against run time, measured and drawn: out/report/index.html."""

import os
import pathlib
import shutil
import sys
import time
from concurrent.futures import ThreadPoolExecutor, as_completed

import machine
import process
import project
from labs import Problem
from process import ROOT
from reporting import digest, page, pieces

SUMMARY = "error against run time, as a page: out/report/index.html"
USAGE = "report [--quick] [--out DIR]"

FULL = {"trials": 16, "most": 4096, "renderings": 20000, "triangles": 50000, "seed": 0}
QUICK = {"trials": 8, "most": 256, "renderings": 2000, "triangles": 5000, "seed": 0}


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("--quick", action="store_true", help="fewer samples and trials: a look at the page, not at the figures")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "report", help="the folder to write to")
    parser.add_argument("--seed", type=int, default=0, help="the first seed; another one gives other random numbers throughout")
    parser.add_argument("--trials", type=int, help="renderings with different seeds (default: 16, or 8 with --quick)")
    parser.add_argument("--most", type=int, help="samples a pixel, at most (default: 4096, or 256 with --quick)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 2, help="programs at a time (default: one a core)")
    wish = parser.parse_args(arguments)
    settings = {**(QUICK if wish.quick else FULL), "seed": wish.seed, "valgrind": bool(shutil.which("valgrind"))}
    settings.update({name: value for name in ("trials", "most") if (value := getattr(wish, name)) is not None})
    for name, value, least in (("seed", wish.seed, 0), ("jobs", wish.jobs, 1), ("trials", settings["trials"], 2), ("most", settings["most"], 256)):
        if value < least:
            raise process.Misuse(f"--{name} is {value}, but must be at least {least}")
    began = time.monotonic()

    machine.ensure("report")
    drawer = machine.plotter()
    if drawer is None:
        raise Problem("no Python with matplotlib is here, which draws the plots: install python3-matplotlib and try again")
    folder = project.configure("release", tests=False)
    settings["tests"] = project.has_tests(folder)
    project.build(folder, "bench_convergence", "bench_ladder", "bench_trace", *(["stress", "trim_kernels"] if settings["tests"] else []))
    if not settings["valgrind"]:
        print("valgrind is not here: the report goes without instruction counts")

    pictures = wish.out / "pictures"
    pictures.mkdir(parents=True, exist_ok=True)
    store = pieces.Store(wish.out / "measured")
    plan = pieces.plan(settings, folder, pictures)
    answers = measure_all(plan, store, wish.jobs)

    report = digest.digest(plan, answers, settings, pieces.environment(folder))
    page.write(report, wish.out, drawer)
    print(f"\nDone in {time.monotonic() - began:.0f} s: {process.shorten(str(wish.out / 'index.html'))}, report.csv, report.json")
    for line in digest.complaints(report):
        print(f"  look at this: {line}")
    return 0


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
