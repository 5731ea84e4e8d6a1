# SPDX-License-Identifier: MIT
"""Does the solution pass its hidden tests whatever the seed? seeds.py NN [COUNT]: tries COUNT (default 200) of them, from 1 on.

The solution is linked in, as in the class's program: ours needs no sandbox, and thousands of seeds take a moment."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import labs  # noqa: E402
import process  # noqa: E402
import student  # noqa: E402


def main() -> int:
    lab = labs.find(sys.argv[1]) if len(sys.argv) > 1 else None
    if lab is None or not (lab.tests / "hidden.cpp").exists():
        sys.exit(f"usage: seeds.py NN [COUNT], of a lab with hidden tests\n{__doc__}")
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 200
    tree, target = student.set_up(), f"{lab.name}_hidden_check"
    if f"{target}:" not in (tree / "build.ninja").read_text(encoding="utf-8"):  # written since the last configuration
        process.need(["cmake", str(tree)], quiet=True)
    built, output = student.build(tree, target)
    if not built:
        sys.exit(student.first_error(output))
    bad = 0
    for seed in range(1, count + 1):
        done = subprocess.run([str(student.program(tree, target))], env={"LANTERN_SEED": str(seed)}, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            bad += 1
            print(f"seed {seed}:\n{done.stdout[-1500:]}", flush=True)
    print(f"lab {lab.number}: {count - bad} of {count} seeds pass")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
