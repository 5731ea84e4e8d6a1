# SPDX-License-Identifier: MIT
"""Does the solution pass its hidden tests whatever the seed? seeds.py NN [COUNT]: tries COUNT (default 200) of them, from 1 on."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import labs  # noqa: E402
from grading import kit, submission  # noqa: E402
from grading.sandbox import Sandbox  # noqa: E402


def main() -> int:
    lab = labs.find(sys.argv[1])
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 200
    with kit.stage_folder() as stage, Sandbox() as box:
        made = submission.verified(kit.made(lab, pathlib.Path(stage)), box)
        if len(made.judges) < 2:
            sys.exit(f"lab {lab.number} has no hidden tests")
        made.scheme.call = made.scheme.case = 600  # laws are tried here, not times
        command = submission.worker_words(made, pathlib.Path(stage) / "reference", box, pathlib.Path(stage))
        bad = 0
        for seed in range(1, count + 1):
            done = subprocess.run([str(made.judges[1])], env=submission.environment_of(made, command, seed), capture_output=True, text=True, check=False)
            if done.returncode != 0:
                bad += 1
                print(f"seed {seed}:\n{done.stdout[-1500:]}")
        print(f"lab {lab.number}: {count - bad} of {count} seeds pass")
        return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
