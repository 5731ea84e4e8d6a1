# SPDX-License-Identifier: MIT
"""price.py PROGRAM: do the robust formulas cost no more than they may?

PROGRAM is stress_price. Valgrind counts the instructions of each of its functions, so load and speed of the machine are no matter.
Without valgrind, or where it does not know the processor's instructions, there is nothing to say: exit code 77, skipped."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import prices  # noqa: E402

SKIPPED = 77
MOST = {"sphere": 2.2, "triangle": 1.8}  # times the instructions of the textbook's formula in float


def main() -> int:
    counts = prices.counted(pathlib.Path(sys.argv[1]))
    if not counts:
        print(f"skipped: there is no valgrind, or it could not run {sys.argv[1]}")
        return SKIPPED
    failed = False
    for name, most in MOST.items():
        textbook, ours = counts[f"price_{name}_textbook"], counts[f"price_{name}_ours"]
        over = ours > most * textbook
        failed = failed or over
        print(f"{name:9} {textbook:6.1f} {ours:6.1f}  {ours / textbook:.3f}{f'   more than {most:g}' if over else ''}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
