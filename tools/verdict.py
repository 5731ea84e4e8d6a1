# SPDX-License-Identifier: MIT
"""Runs a lab's suite step by step, each step in a process of its own, and says what came of it."""

import os
import pathlib
import subprocess
import tempfile
import time
import xml.etree.ElementTree as ET
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

from labs import Lab

SECONDS_PER_STEP = 10.0
PATIENCE = 6


@dataclass
class Test:
    name: str
    passed: bool = False
    finished: bool = False  # False where the process ended in the middle of it
    gap: str = ""        # "lab01 step 2: the sRGB curve" when that is still to be written
    asked: str = ""      # encode(0) == 0
    found: str = ""      # 0.5f == 0
    thrown: str = ""     # what an unexpected exception said
    where: str = ""      # suite.cpp:120
    notes: list[str] = field(default_factory=list)
    hint: dict[str, str] = field(default_factory=dict)  # symptom, cause, read


@dataclass
class Step:
    name: str
    tests: list[Test] = field(default_factory=list)
    trouble: str = ""    # the process as a whole went wrong: "did not finish in 10 s"
    printed: str = ""    # what the student's code wrote

    @property
    def passed(self) -> bool:
        return bool(self.tests) and not self.trouble and all(test.passed for test in self.tests)

    @property
    def failures(self) -> list[Test]:
        return [test for test in self.tests if not test.passed]

    @property
    def gap(self) -> str:
        """What is still to be written, when that is all that is wrong with this step."""
        failures = self.failures
        return failures[0].gap if failures and not self.trouble and all(test.gap for test in failures) else ""


def judge(program: pathlib.Path, lab: Lab, seconds: float | None = None, environment: dict[str, str] | None = None,
          at_once: int | None = None) -> list[Step]:
    """One verdict for each step of the lab."""
    if seconds is None:
        seconds = float(os.environ.get("LANTERN_STEP_SECONDS", SECONDS_PER_STEP))
    with ThreadPoolExecutor(at_once or os.cpu_count()) as pool:
        return list(pool.map(lambda i: run_step(program, i + 1, lab.steps[i], seconds, environment), range(len(lab.steps))))


def run_step(program: pathlib.Path, number: int, name: str, seconds: float, environment: dict[str, str] | None = None) -> Step:
    """Where a test ends the process, the others of its step are run again without it."""
    step = Step(name)
    end = time.monotonic() + seconds
    while True:
        others = "".join(f"~{quoted(test.name)}" for test in step.tests)
        status, tests, printed = run_tests(program, f"[step{number}]{others}", end - time.monotonic(), environment)
        step.printed = step.printed or printed
        seen = {test.name for test in step.tests}
        new = [test for test in tests if test.name not in seen]
        if seen and not new:
            break  # all have been run
        step.tests += new
        if status is None:
            step.trouble = f"did not finish in {seconds:g} s: an endless loop?"
        elif not step.tests:
            step.trouble = "no test was run" + (f" (exit status {status})" if status else "")
        elif status < 0:
            step.trouble = step.trouble or f"crashed ({signal_name(-status)})"
        elif new and not new[-1].finished:
            step.trouble = step.trouble or f"ended the program (exit status {status})"
        elif status != 0 and not step.failures:
            step.trouble = f"ended early (exit status {status})"
        ended_in_a_test = status is not None and new and not (new[-1].finished and status >= 0)
        if not ended_in_a_test or new[-1].passed or time.monotonic() >= end:
            break
    return step


def run_tests(program: pathlib.Path, selection: str, seconds: float,
              environment: dict[str, str] | None = None) -> tuple[int | None, list[Test], str]:
    """The exit status (None: it did not end in time), the tests that were begun, and what was printed."""
    with tempfile.TemporaryDirectory(prefix="lantern-") as folder:
        report = pathlib.Path(folder) / "report.xml"
        command = [str(program), selection, "--reporter", "xml", "--out", str(report)]
        with open(pathlib.Path(folder) / "printed", "w+b") as printed:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=printed, stderr=subprocess.STDOUT,
                                       cwd=folder, start_new_session=True, env=environment)
            try:
                status = patiently(process, max(seconds, 0))
            except subprocess.TimeoutExpired:
                status = None
            finally:
                stop(process)
            printed.seek(0)
            text = printed.read(4000).decode(errors="replace").strip()
        return status, read_report(report.read_bytes() if report.exists() else b""), text


def patiently(process: subprocess.Popen, seconds: float) -> int:
    """Waits that long; longer, up to PATIENCE times, while a program that wants to run has had less than half of that time of the processor:
    a busy machine is no endless loop."""
    latest = time.monotonic() + PATIENCE * seconds
    try:
        return process.wait(seconds)
    except subprocess.TimeoutExpired:
        while time.monotonic() < latest and starved(process.pid, seconds / 2):
            try:
                return process.wait(0.1)
            except subprocess.TimeoutExpired:
                pass
        raise


def starved(pid: int, enough: float) -> bool:
    """Whether a program that does not sleep has had less than `enough` seconds of the processor. Where there is no /proc: no."""
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()
    except OSError:
        return False
    state, used = fields[0], (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")  # proc(5): fields 3, 14 and 15
    return state in ("R", "D", "T") and used < enough


def explained(test: Test) -> list[str]:
    """What a failed test says, line by line."""
    lines = []
    if test.asked:
        lines.append(f"asked:   {test.asked}")
    if test.found and test.found != test.asked:
        lines.append(f"found:   {test.found}")
    if test.thrown:
        lines.append(f"instead: {test.thrown}")
    lines += [f"with:    {text}" for note in test.notes for text in note.splitlines()]
    # What a crash comes from is another thing than what the test is for.
    told = ("read",) if test.thrown.startswith("SIG") else ("symptom", "cause", "read")
    lines += [f"{word + ':':<8} {test.hint[word]}" for word in told if word in test.hint]
    return lines


def quoted(name: str) -> str:
    """A test's name, for Catch2's command line."""
    return '"' + name.replace("\\", "\\\\").replace('"', '\\"').replace("[", "\\[").replace(",", "\\,") + '"'


def stop(process: subprocess.Popen) -> None:
    """The whole process group: student code may have started others."""
    try:
        os.killpg(process.pid, 9)
    except (ProcessLookupError, PermissionError):
        pass
    process.wait()


def signal_name(number: int) -> str:
    words = {6: "aborted", 8: "arithmetic error, such as a division of integers by 0",
             9: "killed, perhaps for want of memory", 11: "memory that is not yours: an index out of range?"}
    return words.get(number, f"signal {number}")


def read_report(report: bytes) -> list[Test]:
    """Catch2's XML, of version 2 or 3. It may end in the middle, where the program died; the last test then failed."""
    parser = ET.XMLPullParser(["start", "end"])
    events = []
    try:
        parser.feed(report)
        for event in parser.read_events():
            events.append(event)
        parser.close()
    except ET.ParseError:
        pass
    tests: list[Test] = []
    for event, node in events:
        if event == "start" and node.tag == "TestCase":
            tests.append(Test(node.get("name", "")))
        elif event == "end" and tests and not tests[-1].passed:
            note(tests[-1], node)
    return tests


def note(test: Test, node: ET.Element) -> None:
    """Fills in what an element says about a test; of several failures the first is kept."""
    text = (node.text or "").strip()
    first = not (test.asked or test.thrown)
    if node.tag == "OverallResult":
        test.finished, test.passed = True, node.get("success") == "true"
    elif not first:
        return
    elif node.tag == "Info":
        if text.startswith("symptom: "):
            test.hint = dict(line.split(": ", 1) for line in text.splitlines() if ": " in line)
        elif text not in test.notes:
            test.notes.append(text)
    elif node.tag == "Failure":
        test.asked, test.where = text or "FAIL", place(node)
    elif node.tag == "Expression" and node.get("success") != "true":
        thrown = node.find("Exception")
        if thrown is None:
            thrown = node.find("FatalErrorCondition")
        test.asked = (node.findtext("Original") or "").strip()
        test.where = place(node)
        if thrown is None:
            test.found = (node.findtext("Expanded") or "").strip()
        else:
            test.thrown = (thrown.text or "").strip()
    elif node.tag in ("Exception", "FatalErrorCondition"):
        test.thrown, test.where = text, place(node)
    if test.thrown.startswith("still to do: "):
        test.gap = test.thrown.removeprefix("still to do: ")


def place(node: ET.Element) -> str:
    return f"{pathlib.Path(node.get('filename', '?')).name}:{node.get('line', '?')}"
