# SPDX-License-Identifier: MIT
"""The front door, behind ./lab: finds the command that was asked for and runs it."""

import importlib
import pathlib
import sys

if sys.version_info < (3, 10):
    sys.exit(f"lab: this is Python {sys.version.split()[0]}; 3.10 or newer is needed")

import process  # noqa: E402  (needs the check above)
from labs import Problem  # noqa: E402

# In the order of the usage. Each is a module in tools/commands/ with SUMMARY, USAGE and run(arguments) -> exit code.
COMMANDS = {
    "Start here": ["demo", "test"],
    "The labs": ["status", "start", "watch", "check", "run", "hint", "compare", "solution", "reset", "list"],
    "For instructors": ["grade", "pack", "release", "new"],
    "The machine": ["doctor", "setup"],
    "For those who change Lantern": ["starters", "mutants", "bench", "report", "stress"],
}


def module(name: str):
    return importlib.import_module(f"commands.{name}")


def exists(name: str) -> bool:
    return (pathlib.Path(__file__).parent / "commands" / f"{name}.py").is_file()


def usage() -> str:
    lines = ["usage: ./lab COMMAND [...]"]
    for title, names in COMMANDS.items():
        found = [module(name) for name in names if exists(name)]
        if found:
            lines += ["", f"{title}:"]
            lines += [f"  {command.USAGE:<34} {command.SUMMARY}" for command in found]
    return "\n".join(lines + ["", "./lab COMMAND --help tells more."])


def main(words: list[str]) -> int:
    if words and words[0] in ("help", "-h", "--help"):
        print(usage())
        return 0
    name, *arguments = words or ["status"]
    if not any(name in names for names in COMMANDS.values()) or not exists(name):
        print(f"lab: unknown command '{name}'\n\n{usage()}", file=sys.stderr)
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
