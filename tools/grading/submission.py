# SPDX-License-Identifier: MIT
"""One submission, from its archive to its marks."""

import hashlib
import os
import pathlib
import re
import shutil
import tempfile
import threading
import time

import macros
import student
import verdict
from grading import archive, pictures, scheme
from grading.kit import CODE, COMPILING, COMPILING_PROGRAM, KIT, OUT, WORKING, Kit
from grading.sandbox import Sandbox
from labs import Problem


class Infrastructure(Exception):
    """The machine failed, not the student: there is no mark, and the submission is to be graded again."""


ATTEMPTS = 3  # at what was late while the machine stood still


class Heartbeat:
    """Notices when this machine stands still: a laptop that sleeps, a container or a grader that is paused. What was too late then says
    nothing about the code. A program that is slow, or sleeps, does not stop this clock: it gets no second attempt."""

    def __init__(self, pause: float = 1.5):
        self.pause, self.longest, self.ended = pause, 0.0, threading.Event()
        self.thread = threading.Thread(target=self._beat, daemon=True)

    def __enter__(self) -> "Heartbeat":
        self.thread.start()
        return self

    def __exit__(self, *_) -> None:
        self.ended.set()
        self.thread.join()

    def _beat(self) -> None:
        last = time.monotonic()
        while not self.ended.wait(self.pause / 5):
            now = time.monotonic()
            self.longest, last = max(self.longest, now - last), now
        self.longest = max(self.longest, time.monotonic() - last)

    @property
    def stood_still(self) -> bool:
        return self.longest > self.pause


def digest(files: dict[str, bytes]) -> str:
    total = hashlib.sha256()
    for name in sorted(files):
        total.update(name.encode() + b"\0" + hashlib.sha256(files[name]).digest())
    return total.hexdigest()[:16]


def graded(kit: Kit, files: dict[str, bytes], box: Sandbox, seed: int, picture_folder: pathlib.Path | None = None,
           keep_worker: pathlib.Path | None = None) -> dict:
    """The marks of a submission, whose files stand as under an include root, as JSON can hold them."""
    began = time.monotonic()
    result = {"lab": kit.lab.number, "status": "graded", "message": "", "score": 0.0, "of": kit.scheme.total, "seed": seed, "steps": [], "pictures": [],
              "left_running": 0}
    with tempfile.TemporaryDirectory(prefix="student-", dir=kit.folder.parent) as name:
        folder = pathlib.Path(name)
        os.chmod(folder, 0o711)
        laid_out(files, folder / "code")
        try:
            worker = compiled(kit, files, box, folder)
            if keep_worker is not None:
                shutil.copy(worker, keep_worker)
            result["steps"] = judged(kit, worker, box, folder, seed)
            result["score"] = round(sum(step["points"] for step in result["steps"]), 2)
            if picture_folder is not None:
                result["pictures"], note = drawn(kit, box, folder, picture_folder)
                result["message"] = note
        except archive.Refused as refused:
            result["status"], result["message"] = "refused", str(refused)
        finally:
            result["left_running"] = box.end_all()
    if not result["steps"]:
        result["steps"] = [failed_step(kit, i) for i in range(len(kit.lab.steps))]
    result["seconds"] = round(time.monotonic() - began, 2)
    return result


def laid_out(files: dict[str, bytes], folder: pathlib.Path) -> None:
    """The files on the disk, readable for the sandbox's user."""
    for path, data in files.items():
        file = folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(data)
    for path in folder.rglob("*"):
        os.chmod(path, 0o755 if path.is_dir() else 0o644)
    os.chmod(folder, 0o755)


def verified(kit: Kit, box: Sandbox) -> Kit:
    """Grades the solution: it must get full marks in this sandbox on this machine, and its tests are those that all submissions have to pass."""
    files = {f"{kit.lab.folder}/{kit.lab.header}": kit.lab.solution_file.read_bytes()}
    kit.tests = []
    result = graded(kit, files, box, seed=1, keep_worker=kit.folder.parent / "reference")
    failed = [test["name"] for step in result["steps"] for test in step["tests"] if not test["passed"]]
    if result["score"] != kit.scheme.total or failed or not all(step["tests"] for step in result["steps"]):
        why = result["message"] or "; ".join(failed or [step["trouble"] for step in result["steps"]])
        raise Problem(f"the solution of lab {kit.lab.number} does not get full marks here, so nobody can be graded: {why}")
    kit.tests = [{test["name"]: test["hidden"] for test in step["tests"]} for step in result["steps"]]
    return kit


def refusal(kit: Kit, why: str, seed: int) -> dict:
    return {"lab": kit.lab.number, "status": "refused", "message": why, "score": 0.0, "of": kit.scheme.total, "seed": seed,
            "steps": [failed_step(kit, i) for i in range(len(kit.lab.steps))], "pictures": [], "left_running": 0, "seconds": 0}


def failed_step(kit: Kit, i: int) -> dict:
    tests = kit.tests[i] if kit.tests else {}
    return {"name": kit.lab.steps[i], "points": 0.0, "of": kit.scheme.steps[i].points, "trouble": "",
            "tests": [{"name": name, "passed": False, "hidden": hidden, "says": []} for name, hidden in tests.items()]}


# ---- Compiling -----------------------------------------------------------------------------------------------------

def compiled(kit: Kit, files: dict[str, bytes], box: Sandbox, folder: pathlib.Path) -> pathlib.Path:
    """The worker. Refused says what is wrong with the header."""
    if not kit.scheme.macros:
        left = [macro for path, data in files.items() for macro in macros.left_behind(data.decode(errors="replace"))]
        if left:
            raise archive.Refused(f"the header leaves macros behind ({', '.join(left[:5])}), which change every file that includes it. "
                                  "Use constexpr values and functions, or #undef them at the end; only an include guard may stay")
    if kit.gate:
        status, printed = compile_in(box, kit.gate_command(), COMPILING, kit, folder, box.own(folder / "gate"))
        if status != 0:
            raise archive.Refused(explained(kit, printed, status))
    out = box.own(folder / "out")
    status, printed = compile_in(box, kit.worker_command(), COMPILING, kit, folder, out)
    if status != 0:
        raise archive.Refused(explained(kit, printed, status))
    return taken(out / "worker", folder / "worker")


def compile_in(box: Sandbox, command: list[str], limits, kit: Kit, folder: pathlib.Path, out: pathlib.Path) -> tuple[int | None, str]:
    for _ in range(ATTEMPTS):
        with Heartbeat() as heart:
            done = compiled_once(box, command, limits, kit, folder, out)
        if done[0] is not None or not heart.stood_still:
            break
    return done


def compiled_once(box: Sandbox, command: list[str], limits, kit: Kit, folder: pathlib.Path, out: pathlib.Path) -> tuple[int | None, str]:
    done = box.run(command, limits, readable={**kit.seen, CODE: folder / "code"}, writable={OUT: out}, system=True)
    return done.status, done.printed.decode(errors="replace")


def taken(made: pathlib.Path, to: pathlib.Path) -> pathlib.Path:
    """What was made in the sandbox, if it is a plain file, where the sandbox cannot change it any more."""
    try:
        descriptor = os.open(made, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
        with os.fdopen(descriptor, "rb") as source, open(to, "wb") as target:
            shutil.copyfileobj(source, target)
    except OSError as problem:
        raise Infrastructure(f"the compiler left no program: {problem.strerror}") from None
    os.chmod(to, 0o755)
    return to


def explained(kit: Kit, printed: str, status: int | None) -> str:
    if status is None:
        return "The header takes too long to compile, or the compiler prints without end."
    if not re.search("error:|undefined reference", printed, re.IGNORECASE) or re.search(r"File size limit|out of memory|cannot allocate|virtual memory exhausted|internal compiler error|Killed signal|No space left",
                                            printed, re.IGNORECASE):
        return "The header takes more time, memory or space to compile than it may."
    text = archive.plain_lines(printed.replace(f"{CODE}/", "labs/").replace(f"{KIT}/lab/", f"tests/labs/{kit.lab.folder}/"))
    text = text.replace(f"{KIT}/include/", "include/").replace(f"{KIT}/support/", "tests/support/")
    return student.explain_build_failure(kit.lab, kit.lab.student_file, text)[:4000]


# ---- Judging -------------------------------------------------------------------------------------------------------

def worker_words(kit: Kit, worker: pathlib.Path, box: Sandbox, folder: pathlib.Path) -> pathlib.Path:
    """The file that tells the judge how to start a worker."""
    words = box.command(["/worker"], WORKING, readable={"/worker": worker})
    file = folder / "command"
    file.write_bytes(b"".join(os.fsencode(word) + b"\0" for word in words))
    return file


def environment_of(kit: Kit, command: pathlib.Path, seed: int) -> dict[str, str]:
    return {"PATH": "/usr/bin:/bin", "LANTERN_WORKER": str(command), "LANTERN_SEED": str(seed),
            "LANTERN_CALL_SECONDS": str(kit.scheme.call), "LANTERN_CASE_SECONDS": str(kit.scheme.case)}


def judged(kit: Kit, worker: pathlib.Path, box: Sandbox, folder: pathlib.Path, seed: int) -> list[dict]:
    environment = environment_of(kit, worker_words(kit, worker, box, folder), seed)
    runs = [verdicts(kit, judge, environment) for judge in kit.judges]
    steps = []
    for i, name in enumerate(kit.lab.steps):
        tests = []
        for run, hidden in zip(runs, (False, True)):
            known = {test.name: test for test in run[i].tests}
            expected = [each for each, is_hidden in kit.tests[i].items() if is_hidden == hidden] if kit.tests else list(known)
            for each in expected:  # what was not reached has not passed
                test = known.get(each) or verdict.Test(each, thrown=run[i].trouble or "was not run")
                tests.append({"name": each, "passed": test.passed, "hidden": hidden, "gap": bool(test.gap),
                              "says": [] if test.passed or (hidden and not kit.show_hidden) else [archive.plain(line) for line in verdict.explained(test)][:30]})
        marks = [scheme.Mark(test["name"], test["passed"], test["hidden"]) for test in tests]
        trouble = runs[0][i].trouble
        steps.append({"name": name, "points": scheme.score(kit.scheme.steps[i], marks), "of": kit.scheme.steps[i].points,
                      "trouble": trouble, "tests": tests})
    if nothing_ever_answered(steps):
        check_the_machine(kit, box, folder, seed)
    return steps


def verdicts(kit: Kit, judge: pathlib.Path, environment: dict[str, str]) -> list[verdict.Step]:
    """One verdict for each step. What was late while the machine stood still is asked again."""
    steps = []
    for number, name in enumerate(kit.lab.steps, 1):
        for _ in range(ATTEMPTS):
            with Heartbeat() as heart:
                step = verdict.run_step(judge, number, name, kit.scheme.step, environment)
            if not (heart.stood_still and was_late(step)):
                break
        steps.append(step)
    return steps


def was_late(step: verdict.Step) -> bool:
    return step.trouble.startswith("did not finish") or any(not test.passed and "did not answer in time" in test.asked + test.thrown for test in step.tests)


def nothing_ever_answered(steps: list[dict]) -> bool:
    """Whether each public test failed because the worker was not there: then the machine is to be looked at."""
    tests = [test for step in steps for test in step["tests"] if not test["hidden"]]
    return all(not test["passed"] and any("the code under test" in line for line in test["says"]) for test in tests)


def check_the_machine(kit: Kit, box: Sandbox, folder: pathlib.Path, seed: int) -> None:
    """Whether the solution's worker would answer in this slot, now. If it does, the silence was the student's."""
    reference = kit.folder.parent / "reference"
    if not reference.exists():
        return
    environment = environment_of(kit, worker_words(kit, reference, box, folder), seed)
    if not any(step.passed for step in verdict.judge(kit.judges[0], kit.lab, kit.scheme.step, environment, at_once=1)):
        raise Infrastructure("the sandbox does not answer even with the solution in it")


# ---- Pictures ------------------------------------------------------------------------------------------------------

def drawn(kit: Kit, box: Sandbox, folder: pathlib.Path, to: pathlib.Path) -> tuple[list[str], str]:
    """The names of the pictures that the lab's program draws with the student's header; or why there are none."""
    out = box.own(folder / "program-out")
    status, printed = compile_in(box, kit.program_command(), COMPILING_PROGRAM, kit, folder, out)
    if status != 0:
        return [], "The lab's program does not compile with this header, so there are no pictures."
    program = taken(out / "program", folder / "program")
    return pictures.drawn(program, box, to)
