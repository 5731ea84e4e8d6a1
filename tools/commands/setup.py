# SPDX-License-Identifier: MIT
"""Install what is missing, and do nothing else."""

import machine
import process

SUMMARY = "install what is missing (demo and test do so by themselves)"
USAGE = "setup [--ci] [--bench]"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("--ci", action="store_true", help="also what .ci/run needs: Clang, valgrind, a browser and more; ./lab doctor lists it")
    parser.add_argument("--bench", action="store_true", help="also what ./lab bench trace can use: Embree, matplotlib, npm")
    wish = parser.parse_args(arguments)
    machine.ensure("ci" if wish.ci else "test")
    if wish.bench:
        machine.ensure("bench")
    print("All is here.")
    return 0
