# SPDX-License-Identifier: MIT
"""Every test, with the default compiler."""

import os

import machine
import process
import project

SUMMARY = "set up, build, and run every test (or those whose names match)"
USAGE = "test [NAME...] [--preset NAME]"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("names", nargs="*", metavar="NAME", help="regular expressions: only tests that one of them matches")
    parser.add_argument("--preset", default="release", help="of CMakePresets.json: release (default), dev, asan, native, clang")
    wish = parser.parse_args(arguments)
    machine.ensure("test")
    folder = project.configure(wish.preset, tests=True)
    project.build(folder)
    command = ["ctest", "--test-dir", str(folder), "--output-on-failure", "--no-tests=error", "-j", str(os.cpu_count() or 2)]
    if wish.names:
        command += ["-R", "|".join(wish.names)]
    return 0 if process.call(command) == 0 else 1
