# SPDX-License-Identifier: MIT
"""From an edit to the verdict: latency.py [NN...] [--times N] edits each lab's header and runs ./lab check, as a student does.

The header is the solution, so that every test is run to its end. Prints a table of the medians: seconds on the clock, and of processors."""

import argparse
import pathlib
import resource
import statistics
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tools"))

import labs  # noqa: E402
import whole  # noqa: E402


def check(lab: labs.Lab) -> tuple[float, float]:
    """Seconds on the clock, and of processors, that a verdict takes."""
    def processors() -> float:
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime

    before, began = processors(), time.monotonic()
    done = subprocess.run([str(ROOT / "lab"), "check", lab.number, "--json"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
    wall = time.monotonic() - began
    if done.returncode != 0:
        raise labs.Problem(f"lab {lab.number}: the solution does not pass:\n{done.stderr[-500:]}")
    return wall, processors() - before


def measured(lab: labs.Lab, times: int) -> tuple[float, float]:
    kept, solution = lab.student_file.read_text(encoding="utf-8"), lab.solution_file.read_text(encoding="utf-8")
    remembered = ROOT / "build" / "progress.json"
    progress = remembered.read_bytes() if remembered.exists() else None
    try:
        whole.write(lab.student_file, solution)
        check(lab)  # builds what an edit does not change
        taken = []
        for i in range(times):
            whole.write(lab.student_file, solution + f"// edit {i}\n")
            taken.append(check(lab))
    finally:
        whole.write(lab.student_file, kept)
        if progress is not None:
            remembered.write_bytes(progress)
    return statistics.median(wall for wall, _ in taken), statistics.median(cpu for _, cpu in taken)


def main() -> int:
    parser = argparse.ArgumentParser(description="from an edit to the verdict, for each lab")
    parser.add_argument("labs", nargs="*", metavar="NN")
    parser.add_argument("--times", type=int, default=5)
    wish = parser.parse_args()
    chosen = [lab for lab in labs.all_labs() if not wish.labs or lab.number in wish.labs]
    if not chosen or wish.times < 1:
        parser.error("no lab is named so, or --times is less than 1")
    for lab in chosen:
        if labs.differs_from_commit(lab.student_file):
            parser.error(f"{lab.student_file.relative_to(ROOT)} has been worked on: this would edit it")
    print("| lab | seconds | of processors |\n|---|---|---|")
    for lab in chosen:
        wall, processors = measured(lab, wish.times)
        print(f"| {lab.number} {lab.title} | {wall:.1f} | {processors:.1f} |", flush=True)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except labs.Problem as problem:
        sys.exit(str(problem))
