# SPDX-License-Identifier: MIT
"""Looks at your file, and says after every save how far you are."""

import contextlib
import os
import select
import shutil
import subprocess
import sys
import tempfile
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
EXAMPLES = """./lab watch 03    from now on; q or Ctrl-C ends it
./lab watch       the lab in hand"""

KEYS = "h hint   n next lab   l list   p picture   r run again   q quit"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY, EXAMPLES)
    student.takes_a_lab(parser, optional=True)
    parser.add_argument("--once", action="store_true", help="one verdict, and the end")
    wish = parser.parse_args(arguments)
    lab = wish.lab or hint.in_hand()
    student.set_up()  # whatever it must install or configure, once, before the screen is ours
    if wish.once:
        show(lab, None)
        return 0
    with keyboard() as key:
        while lab is not None:
            lab = watch(lab, key)
    return 0


def watch(lab: labs.Lab, key) -> labs.Lab | None:
    """One lab, until another is asked for (returned), or none (the end)."""
    seen = pressed = None
    while True:
        now = stamp(lab)
        if now != seen:
            # An editor may write in several steps: wait until it is still.
            while True:
                time.sleep(0.05)
                seen, now = now, stamp(lab)
                if seen == now:
                    break
            pressed = show(lab, key)
            if key is not None:
                print(f"\n{KEYS}", flush=True)
        pressed = pressed or wait(key)
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
            pressed = draw(lab, key)
            print(f"\n{KEYS}", flush=True)
            continue
        pressed = None


def show(lab: labs.Lab, key) -> str | None:
    """The verdict on the file as it is now; when all is done the pictures too. The key that ended the drawing, if one did."""
    clear()
    began = time.monotonic()
    try:
        program = student.built(lab, "_check")
    except student.NotYet as problem:
        print(problem)
        return None
    complaint = student.by_itself(lab, student.tree_of(program))
    steps = verdict.judge(program, lab)
    alone = complaint()
    before = progress.passed(lab, progress.load())
    passed = [step.passed for step in steps]
    progress.remember(lab, passed)
    focus(lab, steps)
    if alone:
        print(f"\n{alone}")
    new = [i for i, (was, now) in enumerate(zip(before, passed), 1) if now and not was]
    if new and not all(passed):
        steps_done = f"Step {new[0]}" if len(new) == 1 else f"Steps {', '.join(map(str, new[:-1]))} and {new[-1]}"
        print(f"\n{steps_done} done. " + ("p shows the picture." if key is not None else f"./lab run {lab.number} shows the picture."))
    print(f"\n{time.monotonic() - began:.1f} s, {time.strftime('%H:%M:%S')}; watching {process.shorten(lab.student_file)}", flush=True)
    return draw(lab, key) if all(passed) else None


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
        print(color.green("\nAll steps pass.") + (f" ./lab solution {lab.number} shows ours beside yours." if lab.solution_file.exists() else ""))
        return
    step = steps[first]
    print()
    if step.gap:
        print(f"Step {first + 1} is still to be written: {process.shorten(lab.handout)} tells how.")
    for line in check.details(step) if not step.gap else []:
        print("  " + line)
    if step.printed:
        print("  Your code printed:")
        print("\n".join("    | " + line for line in step.printed.splitlines()[:8]))


def draw(lab: labs.Lab, key) -> str | None:
    """Runs the lab's program; shows its last picture in a terminal that can, and says where all of them are. There is no limit to its
    time, since a picture may take long: a save or a key ends it. Returns the key."""
    try:
        program = student.built(lab, "")
    except student.NotYet as problem:
        print(problem)
        return None
    began, before, pressed, told = time.monotonic(), stamp(lab), None, False
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as output:
        child = subprocess.Popen([str(program), "out"], cwd=ROOT, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                                 start_new_session=True)
        try:
            while child.poll() is None and stamp(lab) == before and not (pressed := wait(key, 0.05)):
                if not told and time.monotonic() - began > 5:
                    told = True
                    print("drawing; " + ("a save, or any key, ends it ..." if key is not None else "a save ends it ..."), flush=True)
            status = child.poll()
        finally:
            verdict.stop(child)
        output.seek(0)
        paths = [path for line in output if (path := ROOT / line.strip()).suffix in (".png", ".ppm") and path.is_file()]
    if paths:
        columns = min(80, shutil.get_terminal_size().columns - 1)
        print(pictures.shown(paths[-1], columns, pictures.protocol() if sys.stdout.isatty() else ""), end="")
        print("pictures: " + ", ".join(map(process.shorten, paths)), flush=True)
    if status is None:
        print("The drawing was ended before it was done.", flush=True)
    elif status != 0:
        print(f"The program {student.ended(status)}.", flush=True)
    return pressed


def wait(key, seconds: float = 0.2) -> str | None:
    """The key that is pressed meanwhile; without a keyboard just the time."""
    return key(seconds) if key is not None else time.sleep(seconds)


def stamp(lab: labs.Lab) -> tuple[int, int]:
    """Changes when the file does; (0, 0) where there is none."""
    try:
        about = os.stat(lab.student_file)
        return about.st_mtime_ns, about.st_size
    except OSError:
        return 0, 0


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
