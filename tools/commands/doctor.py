# SPDX-License-Identifier: MIT
"""What is here, what is missing, and what would be done about it. Changes nothing."""

import platform
import shlex
import sys

import machine
import process
from labs import ROOT

SUMMARY = "tell what this machine has and lacks"
USAGE = "doctor"

# What each level of work is for; what is needed in any case comes first.
NEEDED = {"build": "every build", "test": "check, watch and ./lab test"}
OPTIONAL = {"grade": "./lab grade", "ci": ".ci/run", "bench": "./lab bench trace", "price": "./lab stress --price", "report": "./lab report"}
HERE = {"grade": ROOT / "grading", "ci": ROOT / ".ci"}  # a course's copy lacks these


def run(arguments: list[str]) -> int:
    process.arguments(USAGE, SUMMARY).parse_args(arguments)
    print(f"{'system':<10} {platform.platform(terse=True)}, {machine.os.cpu_count()} cores")
    print(f"{'python3':<10} {sys.version.split()[0]}")
    levels = {level: what for level, what in (NEEDED | OPTIONAL).items() if HERE.get(level, ROOT).exists()}
    found = machine.look(*levels)
    needed = [finding for finding in found if uses(finding.name, NEEDED)]
    optional = [finding for finding in found if finding not in needed]
    for finding in needed:
        print(line(finding))
    print("\nOnly for some commands:")
    for finding in optional:
        print(f"{line(finding)}, for {', '.join(uses(finding.name, levels))}")
    missing = [finding.name for finding in needed + optional if finding.missing]
    tool = machine.manager()
    if not missing:
        print("\nAll is here.")
    elif not tool:
        print("\nI know none of this machine's package managers: please install by hand what is missing.")
    else:
        print("\n./lab would run, when it needs them:")
        for command in tool.commands(missing):
            print("  " + shlex.join(command))
        for name in missing:
            if name not in machine.PACKAGES[tool.name]:
                print(f"  {name} is in no package that I know of here" + (f"; {machine.SPARED[name]}" if name in machine.SPARED else ""))
    lacking = any(finding.missing and finding.name not in machine.SPARED for finding in needed)
    if not lacking:
        print("Next: ./lab, ./lab demo, ./lab test")
    return 1 if lacking else 0


def uses(need: str, levels: dict[str, str]) -> list[str]:
    """What a thing is needed for, among these levels."""
    return [what for level, what in levels.items() if need in machine.NEEDS[level]]


def line(finding: machine.Finding) -> str:
    return f"{finding.name:<10} " + (finding.found or "missing" + (f" ({finding.remark})" if finding.remark else ""))
