# SPDX-License-Identifier: MIT
"""Install what is missing, and do nothing else."""

import machine
import process

SUMMARY = "install what is missing (demo and test do so by themselves)"
USAGE = "setup [--ci]"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("--ci", action="store_true", help="also what .ci/run needs: a second compiler")
    machine.ensure("ci" if parser.parse_args(arguments).ci else "test")
    print("All is here.")
    return 0
