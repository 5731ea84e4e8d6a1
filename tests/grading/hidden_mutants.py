# SPDX-License-Identifier: MIT
"""Which mutants do the hidden tests catch by themselves? hidden_mutants.py NN...

Those that they miss are caught by the public tests; a student who knows these by heart, and makes that mistake, would not be found out."""

import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import labs  # noqa: E402
import verdict  # noqa: E402
from grading import kit, submission  # noqa: E402
from grading.sandbox import Sandbox  # noqa: E402


def worker_of(made: kit.Kit, header: str, folder: pathlib.Path) -> pathlib.Path:
    """A worker with this header. It is ours: no sandbox, and no more optimising than it takes."""
    code = folder / made.lab.folder
    code.mkdir(parents=True, exist_ok=True)
    (code / made.lab.header).write_text(header, encoding="utf-8")
    command = made.worker_command()
    for name, path in {kit.KIT: made.folder, kit.CODE: folder, kit.OUT: folder}.items():
        command = [word.replace(name, str(path)) for word in command]
    subprocess.run([*command, "-O1"], check=True)
    return folder / "worker"


def failed_by(made: kit.Kit, worker: pathlib.Path, seed: int) -> set[str]:
    (worker.parent / "command").write_bytes(os.fsencode(worker) + b"\0")
    environment = {"LANTERN_WORKER": str(worker.parent / "command"), "LANTERN_SEED": str(seed), "LANTERN_CALL_SECONDS": "60", "LANTERN_CASE_SECONDS": "60"}
    _, tests, _ = verdict.run_tests(made.judges[1], "*", 600, environment)
    return {test.name for test in tests if not test.passed}


def main() -> int:
    for word in sys.argv[1:] or [lab.number for lab in labs.all_labs()]:
        lab = labs.find(word)
        with kit.stage_folder() as name, Sandbox() as box:
            made = submission.verified(kit.made(lab, pathlib.Path(name)), box)
            solution, mutants = lab.solution_file.read_text(encoding="utf-8"), lab.mutants()
            missed = [mutant.name for mutant in mutants
                      if not failed_by(made, worker_of(made, labs.mutate(solution, mutant), pathlib.Path(name) / "mutant"), seed=7)]
        print(f"lab {lab.number}: hidden tests catch {len(mutants) - len(missed)} of {len(mutants)} mutants; not: {', '.join(missed) or 'none'}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
