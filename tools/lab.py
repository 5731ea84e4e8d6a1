# SPDX-License-Identifier: MIT
"""The front door, behind ./lab: finds the command that was asked for and runs it."""

import codecs
import difflib
import importlib
import pathlib
import re
import sys

if sys.version_info < (3, 10):
    sys.exit(f"lab: this is Python {sys.version.split()[0]}; 3.10 or newer is needed")

import process  # noqa: E402  (needs the check above)
from labs import ROOT, Problem  # noqa: E402

# In the order of the usage. Each is a module in tools/commands/ with SUMMARY, USAGE and run(arguments) -> exit code.
COMMANDS = {
    "Start here": ["demo", "test"],
    "The labs": ["status", "start", "watch", "check", "run", "hint", "compare", "explain", "heat", "solution", "reset", "list"],
    "For instructors": ["grade", "pack", "release", "new"],
    "The machine": ["doctor", "setup"],
    "For those who change Lantern": ["starters", "mutants", "bench", "report", "stress"],
}


def module(name: str):
    return importlib.import_module(f"commands.{name}")


def exists(name: str) -> bool:
    return (pathlib.Path(__file__).parent / "commands" / f"{name}.py").is_file()


def offered(name: str) -> bool:
    """Whether the overview names it: a course's copy lacks some commands, and the solutions that others need."""
    return exists(name) and (name not in ("compare", "solution") or (ROOT / "solutions").is_dir())


def usage() -> str:
    lines = ["usage: ./lab COMMAND [...]"]
    found = {title: [(re.sub(r" \[--.*", "", module(name).USAGE), module(name).SUMMARY) for name in names if offered(name)]
             for title, names in COMMANDS.items()}
    widest = max(len(call) for commands in found.values() for call, _ in commands)
    for title, commands in found.items():
        if commands:
            lines += ["", f"{title}:", *(f"  {call:<{widest}}  {summary}" for call, summary in commands)]
    return "\n".join(lines + ["", "./lab COMMAND --help tells more."])


def unknown(name: str) -> str:
    known = [each for names in COMMANDS.values() for each in names if exists(each)]
    near = difflib.get_close_matches(name, known, 1)
    return f"lab: unknown command '{name}'" + (f"; did you mean ./lab {near[0]}?" if near else "") + "\n./lab help lists them all."


# For a terminal that cannot show our marks: passed and failed must not look the same there.
PLAIN = str.maketrans({"✓": "+", "✗": "x", "·": ".", "→": ">", "■": "#", "□": ".", "“": '"', "”": '"', "×": "x", "–": "-", "…": "...",
                       "ξ": "xi", "π": "pi", "√": "sqrt ", "θ": "theta", "²": "^2", "½": "1/2"})


def in_plain_characters(error: UnicodeError) -> tuple[str, int]:
    text = error.object[error.start:error.end]
    return "".join(c if c.isascii() else "?" for c in text.translate(PLAIN)), error.end


def main(words: list[str]) -> int:
    if words and words[0] in ("help", "-h", "--help"):
        print(usage())
        return 0
    name, *arguments = words or ["status"]
    if not any(name in names for names in COMMANDS.values()) or not exists(name):
        print(unknown(name), file=sys.stderr)
        return 2
    command = module(name)
    try:
        return command.run(arguments)
    except process.Misuse as misuse:
        print(f"lab {name}: {misuse}\nusage: ./lab {command.USAGE}", file=sys.stderr)
        return 2
    except BrokenPipeError:
        raise
    except (Problem, OSError) as problem:  # OSError: a full disk, a folder that may not be written
        sys.stdout.flush()
        print(f"lab {name}: {problem}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    codecs.register_error("plain", in_plain_characters)
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="plain")
    try:
        status = main(sys.argv[1:])
        sys.stdout.flush()
    except KeyboardInterrupt:
        print("\nlab: stopped", file=sys.stderr)
        status = 130
    except BrokenPipeError:  # the reader of a pipe has left: ./lab help | head -1
        sys.stderr.close()
        status = 1
    sys.exit(status)
