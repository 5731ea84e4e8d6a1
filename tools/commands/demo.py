# SPDX-License-Identifier: MIT
"""From a bare machine to the first pictures."""

import time

import machine
import process
import project
from process import ROOT

SUMMARY = "set up, build, and render the showcase to out/"
USAGE = "demo"
SHOWCASE = {
    "whitted": "Whitted's scene of 1980: the basic ray tracer",
    "distribution": "soft shadows, gloss, depth of field, motion blur: Cook's distribution ray tracing",
    "many_spheres": "five hundred spheres, and no wait: a bounding volume hierarchy",
}


def run(arguments: list[str]) -> int:
    process.arguments(USAGE, SUMMARY).parse_args(arguments)
    began = time.monotonic()
    machine.ensure("build")
    folder = project.configure("release", tests=False)
    project.build(folder, *SHOWCASE)
    for name in SHOWCASE:
        process.need([str(folder / "examples" / name), str(ROOT / "out" / f"{name}.png")])
    print(f"\nDone in {time.monotonic() - began:.0f} s. The pictures are in {process.shorten(str(ROOT / 'out'))}/, as PNG and PPM:")
    for name, what in SHOWCASE.items():
        print(f"  {name + '.png':<18} {what}")
    print("\nNext:\n  ./lab list      the labs\n  ./lab run 01    the first one: rays as colours\n  ./lab test      all tests")
    return 0
