# SPDX-License-Identifier: MIT
"""Looks at your file, and says after every save how far you are."""

import contextlib
import os
import select
import shutil
import subprocess
import sys
import time

import labs
import pictures
import process
import progress
import student
import verdict
from commands import check, hint
from labs import ROOT

SUMMARY = "rebuild and test after every save, and show what is next"
USAGE = "watch [NN] [--once]"

KEYS = "h hint   n next lab   l list   p picture   r run again   q quit"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("lab", metavar="NN", nargs="?", help="the lab's number (default: the one in hand)")
    parser.add_argument("--once", action="store_true", help="one verdict, and the end: to try it out")
    wish = parser.parse_args(arguments)
    lab = hint.in_hand(wish.lab)
    student.set_up()  # whatever it must install or configure, once, before the screen is ours
    if wish.once:
        show(lab)
        return 0
    with keyboard() as key:
        while lab is not None:
            lab = watch(lab, key)
    return 0


def watch(lab: labs.Lab, key) -> labs.Lab | None:
    """One lab, until another is asked for (returned), or none (the end)."""
    seen = None
    while True:
        now = stamp(lab)
        if now != seen:
            # An editor may write in several steps: wait until it is still.
            while (later := stamp(lab)) != now or time.time() - later_of(later) < 0.05:
                now = later
                time.sleep(0.05)
            seen = now
            show(lab)
            if key is not None:
                print(f"\n{KEYS}", flush=True)
        pressed = key(0.2) if key is not None else time.sleep(0.2)
        if pressed == "q":
            return None
        if pressed == "r":
            seen = None
        elif pressed == "n":
            everything = labs.all_labs()
            place = [each.number for each in everything].index(lab.number)
            return everything[(place + 1) % len(everything)]
        elif pressed == "l":
            from commands import status
            clear()
            status.run([])
            print(f"\n{KEYS}", flush=True)
        elif pressed == "h":
            steps = progress.passed(lab, progress.load())
            print("\n" + (hint.told(lab, steps.index(False) + 1) if False in steps else "Every step passes: there is nothing to hint at."))
            print(f"\n{KEYS}", flush=True)
        elif pressed == "p":
            draw(lab)
            print(f"\n{KEYS}", flush=True)


def show(lab: labs.Lab) -> None:
    """The verdict on the file as it is now, and the picture's path."""
    clear()
    began = time.monotonic()
    try:
        program = student.built(lab, "_check")
    except student.NotYet as problem:
        print(problem)
        return
    steps = verdict.judge(program, lab)
    before = progress.passed(lab, progress.load())
    passed = [step.passed for step in steps]
    progress.remember(lab, passed)
    focus(lab, steps)
    new = [i for i, (was, now) in enumerate(zip(before, passed), 1) if now and not was]
    if new and not all(passed):
        print(f"\nStep {', '.join(map(str, new))} done. ./lab run {lab.number} shows it.")
    print(f"\n{time.monotonic() - began:.1f} s, {time.strftime('%H:%M:%S')}; watching {lab.student_file.relative_to(ROOT)}", flush=True)
    if all(passed):
        draw(lab)


def focus(lab: labs.Lab, steps: list[verdict.Step]) -> None:
    """All steps in a line each; of the first that does not pass, everything."""
    color = check.Colors(sys.stdout.isatty())
    done = sum(step.passed for step in steps)
    print(color.bold(f"Lab {lab.number}: {lab.title}") + f"  [{color.green('#' * done)}{'.' * (len(steps) - done)}]")
    first = next((i for i, step in enumerate(steps) if not step.passed), None)
    for i, step in enumerate(steps):
        mark = color.green("✓") if step.passed else "·" if step.gap else color.red("✗")
        arrow = color.bold("→") if i == first else " "
        rest = "" if step.passed or step.gap else f": {check.summary(step)}"
        print(f"{arrow} {mark} step {i + 1}  {step.name}{rest}")
    if first is None:
        print(color.green(f"\nAll steps pass.") + f" n goes on; ./lab solution {lab.number} shows ours beside yours.")
        return
    step = steps[first]
    print()
    if step.gap:
        print(f"Step {first + 1} is still to be written: labs/{lab.folder}/README.md tells how.")
    for line in check.details(step) if not step.gap else []:
        print("  " + line)
    if step.printed:
        print("  Your code printed:")
        print("\n".join("    | " + line for line in step.printed.splitlines()[:8]))


def draw(lab: labs.Lab) -> None:
    """Runs the lab's program; shows its last picture in a terminal that can, and says where all of them are."""
    try:
        program = student.built(lab, "")
    except student.NotYet as problem:
        print(problem)
        return
    try:
        done = subprocess.run([str(program), "out"], cwd=ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, errors="replace", check=False, timeout=60)
    except subprocess.TimeoutExpired:
        print("The program did not finish in a minute: an endless loop?")
        return
    paths = [path for line in done.stdout.splitlines() if (path := ROOT / line.strip()).suffix in (".png", ".ppm") and path.is_file()]
    if paths:
        columns = min(80, shutil.get_terminal_size().columns - 1)
        print(pictures.shown(paths[-1], columns, pictures.protocol() if sys.stdout.isatty() else ""), end="")
        print("pictures: " + ", ".join(str(path.relative_to(ROOT)) for path in paths), flush=True)
    if done.returncode != 0:
        print(f"The program ended with exit code {done.returncode}.", flush=True)


def stamp(lab: labs.Lab) -> tuple[int, int]:
    """Changes when the file does; (0, 0) where there is none."""
    try:
        about = os.stat(lab.student_file)
        return about.st_mtime_ns, about.st_size
    except OSError:
        return 0, 0


def later_of(seen: tuple[int, int]) -> float:
    return seen[0] / 1e9


def clear() -> None:
    if sys.stdout.isatty():
        print("\033[2J\033[3J\033[H", end="", flush=True)


@contextlib.contextmanager
def keyboard():
    """A function key(seconds) -> the key pressed meanwhile, or None; no function where there is no terminal to press keys at."""
    if not sys.stdin.isatty():
        yield None
        return
    import termios
    import tty
    number = sys.stdin.fileno()
    before = termios.tcgetattr(number)

    def key(seconds: float) -> str | None:
        ready, _, _ = select.select([number], [], [], seconds)
        return os.read(number, 1).decode(errors="replace").lower() if ready else None

    try:
        tty.setcbreak(number)
        yield key
    finally:
        termios.tcsetattr(number, termios.TCSADRAIN, before)
