# SPDX-License-Identifier: MIT
"""Who knows the public tests' answers by heart passes these, and no hidden test: by_heart_test.py [NN...]

The public suite of each lab is asked of the solution, and every answer written down (by_heart.py). A worker that only has that
list must pass all public tests, or the recording is worth nothing, and fail each hidden one, whatever its seed."""

import pathlib
import secrets
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import labs  # noqa: E402
import verdict  # noqa: E402
from grading import kit, submission  # noqa: E402
from grading.sandbox import Sandbox  # noqa: E402

PLAYER = pathlib.Path(__file__).parent / "by_heart.py"
# Steps that ask the same question of everybody: there is nothing to draw anew.
WITHOUT_INPUTS = {("13", 8)}


class ByHeart(unittest.TestCase):
    names: list[str] = []

    def asked(self, judge: pathlib.Path, stage: pathlib.Path, *words: str, seed: int = 1) -> dict[str, bool]:
        command = stage / "command"
        command.write_bytes(b"".join(word.encode() + b"\0" for word in (sys.executable, "-B", str(PLAYER), *words)))
        environment = {"LANTERN_WORKER": str(command), "LANTERN_SEED": str(seed), "LANTERN_CALL_SECONDS": "300", "LANTERN_CASE_SECONDS": "900"}
        _, tests, printed = verdict.run_tests(judge, "*", 1800, environment)
        self.assertTrue(tests, printed)
        return {test.name: test.passed for test in tests}

    def test_the_public_tests_can_be_known_by_heart_and_the_hidden_ones_cannot(self):
        chosen = [lab for lab in labs.all_labs() if (lab.tests / "hidden.cpp").exists() and (not self.names or lab.number in self.names)]
        self.assertTrue(chosen)
        for lab in chosen:
            with self.subTest(lab.folder), kit.stage_folder() as name, Sandbox() as box:
                stage = pathlib.Path(name)
                made = submission.verified(kit.made(lab, stage), box)
                public, hidden = made.judges
                recorded = self.asked(public, stage, "record", str(stage / "known"), str(stage / "reference"))
                self.assertEqual([name for name, passed in recorded.items() if not passed], [])
                played = self.asked(public, stage, "play", str(stage / "known"))
                self.assertEqual([name for name, passed in played.items() if not passed], [], "these answers are not known by heart")
                passed = [name for name, passed in self.asked(hidden, stage, "play", str(stage / "known"), seed=secrets.randbelow(1 << 48)).items() if passed]
                print(f"{lab.folder:<24} {len(played)} public tests known by heart, {len(passed)} hidden ones", file=sys.stderr, flush=True)
                self.assertEqual(passed, [])
                for step in range(1, len(lab.steps) + 1):
                    if (lab.number, step) not in WITHOUT_INPUTS:
                        self.assertIn(True, made.tests[step - 1].values(), f"step {step} has no hidden test")


if __name__ == "__main__":
    ByHeart.names = [word for word in sys.argv[1:] if not word.startswith("-")]
    unittest.main(argv=[sys.argv[0]])
