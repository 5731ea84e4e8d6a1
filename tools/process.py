# SPDX-License-Identifier: MIT
"""Running other programs: shown before they run, ended as a whole when they must end."""

import argparse
import math
import os
import pathlib
import shlex
import signal
import subprocess
import sys
from typing import Callable, Mapping, NoReturn, Sequence

from labs import Problem

ROOT = pathlib.Path(__file__).resolve().parent.parent
TIMED_OUT = 124


class Misuse(Exception):
    """A command was called in a way it does not know. Shown with its usage; the exit code is 2."""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        missing = message.removeprefix("the following arguments are required: ")
        raise Misuse(message if missing == message else f"{missing} is missing")


def arguments(usage: str, summary: str, examples: str = "") -> argparse.ArgumentParser:
    """A parser for one command; wrong arguments raise Misuse. `examples`: lines for the end of its help."""
    return _Parser(prog="./lab", usage=f"./lab {usage}", description=summary, formatter_class=argparse.RawDescriptionHelpFormatter,
                   epilog="examples:\n" + "\n".join("  " + line for line in examples.splitlines()) if examples else None)


def seconds(text: str) -> float:
    """An argument's type: a time to wait."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"'{text}' is no number of seconds above 0")
    return value


def count(text: str) -> int:
    """An argument's type: a number of things, or of one of them."""
    if not text.isascii() or not text.isdigit():
        raise argparse.ArgumentTypeError(f"'{text}' is no whole number")
    return int(text)


def show(argv: Sequence[str]) -> None:
    """Prints a command as one could type it."""
    line = "$ " + shlex.join(shorten(word) for word in argv)
    print(f"\033[2m{line}\033[0m" if sys.stdout.isatty() else line, flush=True)


def shorten(word: str | pathlib.Path) -> str:
    """A path in this checkout, as seen from where the user stands."""
    word = str(word)
    if word.startswith(str(ROOT)):
        seen = os.path.relpath(word)
        return seen if len(seen) < len(word) else word
    return word


def call(argv: Sequence[str], *, quiet: bool = False, cwd: pathlib.Path | None = None, timeout: float | None = None,
         environment: Mapping[str, str] | None = None, terminal: bool = False) -> int:
    """Shows the command, runs it and returns its exit code; TIMED_OUT when it took longer than `timeout` seconds.

    Whatever ends the wait (a timeout, Ctrl-C) ends the command and all that it started. `quiet` shows nothing unless
    the command fails. `terminal` leaves it the terminal, to ask for a password."""
    if not quiet:
        show(argv)
    output = subprocess.PIPE if quiet else None
    try:
        child = subprocess.Popen(argv, cwd=cwd, stdin=subprocess.DEVNULL, stdout=output,
                                 stderr=subprocess.STDOUT if quiet else None, text=True, errors="replace",
                                 env={**os.environ, **(environment or {})}, start_new_session=not terminal)
    except OSError as error:
        raise Problem(f"{argv[0]} cannot be run: {error.strerror}") from error
    try:
        text, _ = child.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        _end(child)
        return TIMED_OUT
    except BaseException:
        _end(child)
        raise
    if quiet and child.returncode != 0:
        show(argv)
        sys.stdout.write(text)
    return child.returncode


def need(argv: Sequence[str], **options) -> None:
    """Runs a command that must succeed."""
    code = call(argv, **options)
    if code != 0:
        raise Problem(f"this command failed with exit code {code}:\n  {shlex.join(shorten(word) for word in argv)}")


def followed(argv: Sequence[str], line: Callable[[str], None]) -> tuple[int, str]:
    """As capture, but `line` is told each line as it comes."""
    try:
        child = subprocess.Popen(argv, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    except OSError as error:
        return 127, str(error)
    said = []
    with child:
        for text in child.stdout:
            said.append(text)
            line(text)
    return child.returncode, "".join(said)


def capture(argv: Sequence[str], text: str | None = None) -> tuple[int, str]:
    """Runs a command in silence. Exit code (127 when there is no such program) and all that it printed."""
    try:
        done = subprocess.run(argv, input=text if text is not None else "", stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
    except OSError as error:
        return 127, str(error)
    return done.returncode, done.stdout


def _end(child: subprocess.Popen) -> None:
    """Ends a command and what it started: asked first, made to after two seconds."""
    for number, patience in ((signal.SIGTERM, 2), (signal.SIGKILL, 5)):
        try:
            if os.getpgid(child.pid) == child.pid:
                os.killpg(child.pid, number)
            else:
                child.send_signal(number)
        except (ProcessLookupError, PermissionError):  # it has ended, or sudo runs it and ends it by itself
            pass
        try:
            child.communicate(timeout=patience)
            return
        except subprocess.TimeoutExpired:
            continue
