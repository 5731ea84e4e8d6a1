# SPDX-License-Identifier: MIT
"""trim_cost.py PROGRAM [LIMIT]: does a trimmed scene run no more instructions than a kernel written by hand for it?

PROGRAM is trim_kernels. Valgrind counts the instructions of each kernel, so load and speed of the machine are no
matter; the pictures must be the same. More than LIMIT per cent (1) above the kernel by hand is a failure. Without
valgrind, or where it does not know the processor's instructions, there is nothing to say: exit code 77, skipped."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

import callgrind  # noqa: E402

SCENES = ("static", "lens", "motion", "gloss", "shadow", "all")
SKIPPED = 77
SIDE = "12"


def main() -> int:
    program = sys.argv[1]
    limit = float(sys.argv[2]) if len(sys.argv) > 2 else 1.0
    if not callgrind.is_here():
        print("skipped: there is no valgrind to count instructions with")
        return SKIPPED
    failed = False
    samples = 4 * int(SIDE) ** 2
    print(f"{'scene':8} {'by hand':>9} {'trimmed':>9} {'':>8} {'everything':>11}   instructions a sample")
    for scene in SCENES:
        counts = {}
        for kernel in ("stripped", "trimmed", "everything"):
            try:
                counts[kernel] = callgrind.count([program, scene, kernel, SIDE], within="*measured*")
            except callgrind.Failed as problem:
                print(f"skipped: {problem}")
                return SKIPPED
        hand, trimmed, everything = (counts[k].instructions for k in ("stripped", "trimmed", "everything"))
        above = 100 * (trimmed / hand - 1)
        verdict = "" if above <= limit else f"   more than {limit:g} % above"
        if len({each.printed for each in counts.values()}) > 1:
            verdict += "   the pictures differ"
        failed = failed or bool(verdict)
        print(f"{scene:8} {hand / samples:9.1f} {trimmed / samples:9.1f} {above:+7.2f}% {everything / samples:11.1f}{verdict}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
