# SPDX-License-Identifier: MIT
"""What a student's curve is called, and why: from rows made for the purpose."""

import math
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from reporting import judgement, points  # noqa: E402

COUNTS = [4, 10, 16, 40, 64, 160, 256]


def curve(slope: float, *, scale: float = 0.3, off: dict[int, float] | None = None, counts: list[int] | None = None, **more) -> dict:
    """Falls with this slope, and has biases at some numbers of samples."""
    rows = []
    for n in COUNTS if counts is None else counts:
        noise, bias = scale * n ** slope, (off or {}).get(n, 0)
        rows.append({"samples": n, "rmse": math.hypot(noise, bias), "rmse_low": 0.98 * noise, "rmse_high": 1.02 * noise, "z": 0.5, "bias": 0,
                     "pixel_bias": bias, "pixel_z": 200 * (bias / noise) ** 2})
    one = {"rows": rows, "slope": slope, "slope_low": slope - 0.01, "slope_high": slope + 0.01, "half_error_costs": 2 ** (-1 / slope) if slope < 0 else None,
           "trials": 16, "not_finite": 0, "outside": 0, "points": 1000, "end": {"kind": "", "says": ""}, "effect": "gloss", "pattern": "p"}
    return {**one, **more}


OURS = curve(-0.75, counts=[4, 16, 64, 256])


class Judgement(unittest.TestCase):
    def judged(self, one: dict, kind: str, *words: str) -> None:
        found, text = judgement.judge(one, OURS)
        self.assertEqual(found, kind, text)
        for each in words:
            self.assertIn(each, text)

    def test_student_s_t_has_the_tails_of_the_tables(self):
        for trials, t in ((2, 25464.79), (3, 199.996), (4, 44.5), (16, 5.98)):  # two-sided, 2.5e-5
            self.assertAlmostEqual(judgement.limit(trials) / t, 1, delta=0.005)
        self.assertAlmostEqual(judgement.limit(100000), 4.2149, delta=0.002)  # the normal distribution's

    def test_as_ours(self):
        self.judged(curve(-0.75), "sound", "no bias", "−0.75 ± 0.01", "at 256 samples the error is 1.00 times ours")

    def test_better_and_worse(self):
        self.judged(curve(-0.75, scale=0.2), "better", "0.67 times ours")
        self.judged(curve(-0.75, scale=0.4), "worse", "1.33 times ours")

    def test_slow(self):
        self.judged(curve(-0.5), "slow", "half the error costs 4.0 times the time, and ours 2.5 times")

    def test_a_slope_within_its_interval_is_not_slow(self):
        self.judged(curve(-0.72, scale=0.26, slope_low=-0.8, slope_high=-0.6), "sound")

    def test_biased_though_the_mean_over_the_picture_is_right(self):
        self.judged(curve(-0.75, off={256: 0.02}), "biased", "at 256 samples", "0.02")

    def test_biased_where_the_number_is_no_square(self):
        self.judged(curve(-0.75, off={n: 0.05 for n in (40, 160)}), "biased", "look at the numbers that are none")

    def test_two_trials_prove_less_than_sixteen(self):
        rows = [{**row, "z": 8.0} for row in curve(-0.75)["rows"]]
        self.judged(curve(-0.75, rows=rows), "biased", "z = 8")
        self.judged(curve(-0.75, rows=rows, trials=4), "sound")

    def test_the_seed_does_nothing(self):
        rows = [{**row, "rmse_low": row["rmse"], "rmse_high": row["rmse"], "z": 999.0} for row in curve(0)["rows"]]
        self.judged(curve(0, rows=rows), "repeats")

    def test_points_outside_are_told_first(self):
        self.judged(curve(-0.75, outside=3), "biased", "3 of 1 000 points lie outside")

    def test_stopped(self):
        self.judged(curve(-0.75, counts=[4, 10, 16], end={"kind": "crash", "says": "SIGFPE"}), "broken", "It crashed after 16 samples", "As far as it came: right")
        self.judged(curve(-0.75, counts=[], end={"kind": "time", "says": ""}), "broken", "before the first picture was done")
        self.judged(curve(-0.75, counts=[], end={"kind": "gap", "says": "lab13 step 5: a grid"}), "gap", "lab13 step 5")

    def test_how_a_program_ended(self):
        self.assertEqual(points.how(-9, True, True, "").kind, "time")
        self.assertEqual(points.how(-24, False, True, "").kind, "time")
        self.assertEqual(points.how(128 + 24, False, True, "").kind, "time")  # as a sandbox says it
        self.assertEqual(points.how(-9, False, True, "").kind, "crash")
        self.assertIn("divided by zero", points.how(128 + 8, False, True, "").says)
        self.assertEqual(points.how(3, False, True, "x\nwhat it threw\n"), points.End("threw", "what it threw"))
        self.assertEqual(points.how(0, True, True, "").kind, "early")
        self.assertIn("printed something", points.how(-13, False, False, "").says)


if __name__ == "__main__":
    unittest.main()
