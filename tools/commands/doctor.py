# SPDX-License-Identifier: MIT
"""What is here, what is missing, and what would be done about it. Changes nothing."""

import platform
import shlex
import sys

import machine
import process

SUMMARY = "tell what this machine has and lacks"
USAGE = "doctor"
FOR = {need: level for level, needs in machine.NEEDS.items() for need in needs}
PURPOSE = {"build": "", "test": "for ./lab test and check", "grade": "for ./lab grade alone", "ci": "for .ci/run alone",
           "bench": "for ./lab bench trace alone", "price": "for ./lab stress --price alone", "report": "for ./lab report alone"}


def run(arguments: list[str]) -> int:
    process.arguments(USAGE, SUMMARY).parse_args(arguments)
    print(f"{'system':<10} {platform.platform(terse=True)}, {machine.os.cpu_count()} cores")
    print(f"{'python3':<10} {sys.version.split()[0]}")
    missing = []
    for finding in machine.look("ci", "bench"):
        purpose = PURPOSE[FOR[finding.name]]
        state = finding.found or "missing" + (f" ({finding.remark})" if finding.remark else "")
        print(f"{finding.name:<10} {state}" + (f", {purpose}" if finding.missing and purpose else ""))
        if finding.missing:
            missing.append(finding.name)
    needed = [name for name in missing if FOR[name] in ("build", "test")]
    tool = machine.manager()
    if not missing:
        print("\nAll is here.")
    elif not tool:
        print("\nI know none of this machine's package managers: please install by hand what is missing.")
    else:
        print("\n./lab would run, when it needs them:")
        for command in tool.commands(missing):
            print("  " + shlex.join(command))
    if not needed:
        print("Next: ./lab demo, ./lab test, ./lab list")
    return 1 if needed else 0
