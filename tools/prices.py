# SPDX-License-Identifier: MIT
"""What being right costs: error and price of the textbooks' formulas, beside ours."""

import pathlib
import subprocess

import callgrind

# A formula, and the cases of the scorecard that judge it.
PRICED = {
    "sphere": ["sphere/"],
    "triangle": ["triangle/", "watertightness/"],
    "plane": ["plane/"],
    "box": ["boxes/"],
    "basis": ["basis/"],
    "refraction": ["refraction/"],
    "leave": ["self-intersection/"],
    "mean": ["image/mean"],
}
CALLS = 4096  # of each function that stress_price makes


def table(textbook: list[dict], library: list[dict], costs: dict[str, float]) -> list[dict]:
    """A formula a row, from the cases of both scorecards and the costs of both functions, whatever these are counted in."""
    rows = []
    for name in PRICED:
        row: dict = {"formula": name}
        for who, cases in (("textbook", textbook), ("ours", library)):
            wrong, ulp = errors(name, cases)
            row |= {f"{who}_wrong": wrong, f"{who}_ulp_max": ulp, f"{who}_cost": costs[f"price_{name}_{who}"]}
        rows.append(row | {"ratio": row["ours_cost"] / row["textbook_cost"]})
    return rows


def errors(name: str, cases: list[dict]) -> tuple[int, float]:
    """How many answers of the formula's cases are wrong, and the largest error."""
    mine = [case for case in cases if case["verdict"] != "n/a" and case["id"].startswith(tuple(PRICED[name]))]
    return sum(case["wrong"] for case in mine), max((case["ulp_max"] for case in mine), default=0.0)


def counted(program: pathlib.Path) -> dict[str, float]:
    """Of each function, how many instructions a call takes; nothing where they cannot be counted."""
    try:
        return of_calls(callgrind.count([str(program), "once"], by_function=True).called)
    except callgrind.Failed:
        return {}


def of_calls(called: dict[str, int]) -> dict[str, float]:
    return {name: cost / CALLS for name, cost in called.items() if name.startswith("price_")}


def timed(program: pathlib.Path) -> dict[str, float]:
    """Nanoseconds a call."""
    done = subprocess.run([str(program)], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=True)
    return nanoseconds(done.stdout)


def nanoseconds(printed: str) -> dict[str, float]:
    return {name: float(value) for name, value in (line.split() for line in printed.splitlines()) if name.startswith("price_")}
