# SPDX-License-Identifier: MIT
"""Measuring a sampler that nobody trusts: one process runs it and writes its points, another one renders with them and measures."""

import json
import os
import signal
import subprocess
import threading
import time
from dataclasses import dataclass
from typing import IO, Any

from labs import Problem

CPU = 30      # seconds of the processor that the points of one curve may take
WALL = 600    # seconds by the clock, for code that sleeps
KEPT = 2000   # bytes of what the code says


@dataclass
class End:
    """How that program ended: "" as it should, "time", "crash", "threw", "gap" (not written yet), "early"."""
    kind: str
    says: str = ""


def limited(program: str) -> list[str]:
    """A program of one's own: no sandbox, but it ends."""
    return ["/bin/sh", "-c", f'ulimit -t {CPU} -c 0; exec "$0" "$@"', program]


def measured(maker: list[str], options: list[str], measuring: list[str]) -> dict[str, Any]:
    """The curve, as far as there are points, and how the program that made them ended. `maker` and its options write what
    `measuring`, the program convergence, reads."""
    began = time.monotonic()
    child = subprocess.Popen([*maker, *options], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
    words = Words(child.stderr)
    try:
        reader = subprocess.Popen(measuring, stdin=child.stdout, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace")
        child.stdout.close()
        late = False
        try:
            answer, complaint = reader.communicate(timeout=WALL)
        except subprocess.TimeoutExpired:
            kill(child)
            answer, complaint = reader.communicate()
            late = True
        status = ended(child)
    finally:
        kill(child)
    if reader.returncode != 0:
        raise Problem(f"this command failed with exit code {reader.returncode}:\n  {' '.join(measuring)}\n{complaint}")
    curve = json.loads(answer)["curves"][0]
    complete = bool(curve["rows"]) and curve["rows"][-1]["samples"] == int(options[options.index("--counts") + 1].split(",")[-1])
    end = End("") if complete else how(status, late or time.monotonic() - began > CPU, curve["begun"], words.last())
    return {"curve": curve, "end": vars(end)}


class Words:
    """The end of what a program says, be it ever so much: somebody may be looking for an error by printing."""

    def __init__(self, stream: IO[bytes]):
        self.stream, self.kept = stream, b""
        self.thread = threading.Thread(target=self._listen, daemon=True)
        self.thread.start()

    def _listen(self) -> None:
        while piece := self.stream.read1(1 << 16):
            self.kept = (self.kept + piece)[-KEPT:]

    def last(self) -> str:
        self.thread.join(1)  # one that it started may still hold the other end
        return self.kept.decode(errors="replace")


def ended(child: subprocess.Popen) -> int:
    """Waits, not for long: its points have been read, or it has been killed."""
    try:
        return child.wait(5)
    except subprocess.TimeoutExpired:
        kill(child)
        return child.wait()


def kill(child: subprocess.Popen) -> None:
    try:
        os.killpg(child.pid, signal.SIGKILL)
    except (ProcessLookupError, PermissionError):
        pass


def how(status: int, long: bool, begun: bool, words: str) -> End:
    """In words, why the points ended too early; `long`: after as many seconds as it may take. A sandbox tells a signal as 128 and its
    number."""
    number = -status if status < 0 else status - 128 if 128 < status < 160 else 0
    if not begun and (number == signal.SIGPIPE or status == 0):
        return End("early", "it printed something, or went away, before it was asked for anything")
    last = words.strip().splitlines()[-1] if words.strip() else ""
    if number == signal.SIGXCPU or long and number == signal.SIGKILL:
        return End("time")
    if number:
        try:
            name = signal.Signals(number).name
        except ValueError:
            name = f"signal {number}"
        meaning = {"SIGSEGV": "it used memory that is not its own", "SIGFPE": "it divided by zero, in integers",
                   "SIGKILL": "it was ended from outside, as for taking more memory than it may",
                   "SIGABRT": "it gave up: an assertion, or an exception nobody caught", "SIGILL": "it ran into code that must not be reached"}
        return End("crash", name + (f": {meaning[name]}" if name in meaning else "") + (f". It said: {last[:200]}" if last and name == "SIGABRT" else ""))
    if status == 4:
        return End("gap", last[:300])
    if status == 3:
        return End("threw", last[:300])
    return End("early", f"by itself, with exit code {status}")
