# SPDX-License-Identifier: MIT
"""From measurements to figures and to sentences."""

import statistics
from typing import Any, Iterable

import prices
from reporting import judgement, pieces

# What the slope of RMSE against samples must come to for many samples. Two numbers a sample, an edge across the square: only
# the cells that it crosses are uncertain, hence -3/4 for every sampler that fills cells (docs/headers/exact_error.md). One number,
# N strata: -1. N-rooks fill rows and columns alone: an edge at a slant gains nothing from that in the limit. Four
# numbers, two for each of two purposes that are shuffled against each other: what both together decide is left to chance, -1/2. Sobol's
# points are spread in all four: an edge in n dimensions leaves -1/2 - 1/2n.
THEORY = {1: {"random": -0.5}, 2: {"random": -0.5, "N-rooks": -0.5}, 4: {"Sobol": -0.625}}
STRATIFIED = {1: -1.0, 2: -0.75, 4: -0.5}


# A bootstrap over 16 trials gives intervals that are a little too narrow: they hold the truth about nine times in ten.
SLACK = 0.005


def near(most: int) -> float:
    """As far from a limit for many samples as a fit that ends at so many may leave a slope."""
    return 0.03 if most >= 1024 else 0.06


def theory(sampler: str, dimensions: int) -> float:
    return THEORY[dimensions].get(sampler, STRATIFIED[dimensions])


def in_words(slope: float) -> str:
    return {-0.5: "−1/2", -0.625: "−5/8", -0.75: "−3/4", -1.0: "−1"}[slope]


def digest(answers: dict[str, Any], settings: dict, environment: dict, own: list[dict], submissions: list[dict]) -> dict:
    """Everything that the page shows, as one JSON value. `own` and `submissions` are what students.py measured, a header an entry."""
    effects = []
    for effect in pieces.EFFECTS:
        curves = [ours(answers[f"{effect}, {sampler}"]) for sampler in pieces.SAMPLERS]
        effects.append({"name": effect, "tells": curves[0]["tells"], "dimensions": curves[0]["dimensions"],
                        "pixels": curves[0]["pixels"], "curves": curves})
    for effect in effects:
        effect["sentence"] = sentence(effect)
    return {"environment": environment, "settings": settings, "effects": effects, "ladder": ladder(answers),
            "accelerators": accelerators(answers), "stability": stability(answers), "prices": price_table(answers), "leaving_out": leaving_out(answers),
            "own": [beside_ours(entry, effects) for entry in own],
            "submissions": outliers([beside_ours(entry, effects) for entry in submissions])}


def ours(answer: dict) -> dict:
    """One of our samplers on one effect: what was measured, and what follows from it."""
    one = dict(answer["curves"][0])
    complete(one, answer, theory(one["sampler"], one["dimensions"]))
    one["verdict"] = verdict(one)
    return one


def complete(one: dict, answer: dict, limit: float) -> None:
    """Adds what follows from a curve's rows."""
    one["pixels"] = answer["width"] * answer["height"]
    one["fitted_from"], one["trials"] = answer["fitted_from"], answer["trials"]
    one["theory"] = limit
    one["largest_z"] = max((judgement.bias_z(row) for row in one["rows"]), default=0)
    one["biased"] = any(judgement.is_biased(row, one["trials"]) for row in one["rows"])
    one["not_finite"] = sum(row["not_finite"] for row in one["rows"])
    per_sample = one["seconds_per_sample"]
    for row in one["rows"]:
        row["seconds"] = row["samples"] * per_sample * one["pixels"] if per_sample else None
    one["half_error_costs"] = 2 ** (-1 / one["slope"]) if one["slope"] and one["slope"] < 0 else None
    samples = one["samples_to_one_percent"]
    reached = samples is not None and samples < 2 ** 40  # beyond, the line is too flat to be followed so far
    one["seconds_to_one_percent"] = samples * per_sample * one["pixels"] if reached and per_sample else None


# ---- Students' curves ----------------------------------------------------------------------------------------------

def beside_ours(entry: dict, effects: list[dict]) -> dict:
    """An entry of students.py with what its curves mean, beside ours of the same pictures."""
    entry = {**entry, "curves": [theirs(one, effects) for one in entry["curves"]]}
    return {**entry, "worst": judgement.worst(entry), "headline": judgement.headline(entry)}


def theirs(measured: dict, effects: list[dict]) -> dict:
    effect = next(each for each in effects if each["name"] == measured["effect"])
    model = next(each for each in effect["curves"] if each["sampler"] == measured["beside"])
    one = {**measured["curve"], **{key: measured[key] for key in ("pattern", "effect", "beside", "end")}}
    making = one["making_seconds"]
    points_a_sample = (one["dimensions"] + 1) // 2
    # Rendering with points that are there, and the making of these.
    one["seconds_per_sample"] = one["seconds_per_sample"] + making * points_a_sample if making is not None else None
    complete(one, {"width": 1, "height": model["pixels"], "fitted_from": model["fitted_from"], "trials": model["trials"]}, model["theory"])
    one["time_beside_ours"] = one["seconds_per_sample"] / model["seconds_per_sample"] if one["seconds_per_sample"] else None
    one["rmse_beside_ours"] = judgement.beside(one["rows"], model)[0]
    one["kind"], one["sentence"] = judgement.judge(one, model)
    return one


def outliers(entries: list[dict]) -> list[dict]:
    """Marks what an instructor should look at: what is not sound, and what differs by more than 15 % from the class's median."""
    ratios: dict[tuple[str, str], list[float]] = {}
    for entry in entries:
        for one in entry["curves"]:
            if one["rmse_beside_ours"] and not one["end"]["kind"]:
                ratios.setdefault((one["pattern"], one["effect"]), []).append(one["rmse_beside_ours"])
    for entry in entries:
        for one in entry["curves"]:
            middle = statistics.median(ratios.get((one["pattern"], one["effect"]), [1.0]))
            far = one["rmse_beside_ours"] is not None and not 1 / judgement.AS_GOOD <= one["rmse_beside_ours"] / middle <= judgement.AS_GOOD
            one["outlier"] = far or one["kind"] not in judgement.GOOD
        entry["outlier"] = bool(entry["message"]) or any(one["outlier"] for one in entry["curves"])
    return entries


# ---- Ours ----------------------------------------------------------------------------------------------------------

def verdict(one: dict) -> str:
    """How the measured slope stands to theory."""
    low, high, limit, found = one["slope_low"], one["slope_high"], one["theory"], one["predicted_slope"]
    if low - SLACK <= limit <= high + SLACK:
        return "as theory says"
    if found is not None and low - SLACK <= found <= high + SLACK:
        return f"as the closed form says for these numbers of samples: {judgement.number(found, '{:.3f}')}"
    if abs(one["slope"] - limit) <= near(one["rows"][-1]["samples"]):
        return f"near the limit {in_words(limit)} for many samples"
    if one["sampler"] == "N-rooks" and one["slope"] < limit:
        return "better than its limit −1/2: these edges are nearly upright, and rows and columns help there"
    return "not explained"


def sentence(effect: dict) -> str:
    """The curve of jittered samples, in words."""
    one = next(c for c in effect["curves"] if c["sampler"] == "jittered")
    bias = "no bias" if not one["biased"] else f"a bias (z = {one['largest_z']:.1f})"
    what = {1: "one moment of change", 2: "an edge", 4: "two purposes that are stratified each by itself"}[effect["dimensions"]]
    cost = f"half the error costs {one['half_error_costs']:.1f} times the time" if one["half_error_costs"] else "the error does not fall"
    best = min((c for c in effect["curves"] if c["seconds_to_one_percent"]), key=lambda c: c["seconds_to_one_percent"], default=None)
    slopes = {c["sampler"]: c["slope"] for c in effect["curves"]}
    both = (" What decides is both together, and strata for each purpose by itself are of little use; Sobol's points are spread in all four dimensions."
            if effect["dimensions"] == 4 and slopes["Sobol"] < one["slope_low"] else "")
    first = f"Jittered samples: slope {judgement.with_interval(one)}; theory for {what} {in_words(one['theory'])}; {bias}; {cost}."
    if best is None:
        return first
    random = next(c for c in effect["curves"] if c["sampler"] == "random")
    gain = random["seconds_to_one_percent"] / best["seconds_to_one_percent"] if random["seconds_to_one_percent"] else 0
    return first + (f" An error of 1 % is reached first by {best['sampler']} samples, {gain:.0f} times sooner than by random ones."
                    if gain > 1 else "") + both


def ladder(answers: dict[str, Any]) -> dict:
    """The effects added one by one, with instructions a sample where they were counted."""
    result = dict(answers["the ladder of effects"])
    for i, rung in enumerate(result["rungs"]):
        few, many = (answers.get(f"instructions of rung {i}, {n} renderings") for n in (100, 600))
        rung["instructions"] = (many - few) / (500 * result["samples"]) if few and many else None
        rung["leaves_out"] = [later["adds"] for later in result["rungs"][i + 1:]]
    return result


def accelerators(answers: dict[str, Any]) -> list[dict]:
    """A structure a row, for primary rays. It breaks even after as many rays as its building takes the time of, less what they
    take with it, when all surfaces are tried instead."""
    measured = [row for row in answers["accelerators"]["rows"] if row["rays"] == "primary" and row["threads"] == 1]
    brute = next(row for row in measured if row["structure"] == "every")
    result = []
    for row in measured:
        gain = 1 / brute["mrays"] - 1 / row["mrays"]  # microseconds a ray
        result.append({**row, "breaks_even": 1000 * row["build_ms"] / gain if gain > 0 else None})
    return result


def stability(answers: dict[str, Any]) -> list[dict]:
    """The scorecard by groups."""
    groups: dict[str, dict] = {}
    for case in answers.get("stability", {}).get("cases", []):
        group = groups.setdefault(case["group"], {"group": case["group"], "cases": 0, "wrong": 0, "ulp_max": 0.0, "failed": []})
        group["cases"] += 1
        group["wrong"] += case["wrong"]
        group["ulp_max"] = max(group["ulp_max"], case["ulp_max"])
        if case["verdict"] == "fail":
            group["failed"].append(case["id"])
    return list(groups.values())


def price_table(answers: dict[str, Any]) -> list[dict]:
    """Error and cost of the textbooks' formulas beside ours; nothing where the tests were not built."""
    both = [answers.get(name, {}).get("cases") for name in ("stability of the textbook", "stability")]
    return prices.table(*both, answers["prices"]) if all(both) and answers.get("prices") else []


def leaving_out(answers: dict[str, Any]) -> list[dict]:
    """Instructions a sample: written by hand for the scene, trimmed at run time, and with everything on."""
    found = []
    for scene in pieces.TRIMMED:
        counts = {kernel: answers.get(f"leaving out: {scene}, {kernel}") for kernel in pieces.KERNELS}
        if all(counts.values()):
            found.append({"scene": scene, **{kernel: count / (4 * pieces.TRIM_SIDE ** 2) for kernel, count in counts.items()}})
    return found


def rows(report: dict) -> Iterable[dict]:
    """The curves, one measurement a row: report.csv."""
    for effect in report["effects"]:
        for one in effect["curves"]:
            for row in one["rows"]:
                yield {"whose": "ours", "effect": effect["name"], "sampler": one["sampler"], **row}
    for entry in report["own"] + report["submissions"]:
        for one in entry["curves"]:
            for row in one["rows"]:
                yield {"whose": entry.get("cell", entry["name"]), "effect": one["effect"], "sampler": one["pattern"], **row}


def complaints(report: dict) -> list[str]:
    """What a reader should look at before believing the rest."""
    found = []
    for effect in report["effects"]:
        for one in effect["curves"]:
            name = f"{effect['name']}, {one['sampler']}"
            if one["not_finite"]:
                found.append(f"{name}: {one['not_finite']} values are not finite")
            if one["biased"]:
                found.append(f"{name}: a bias, z = {one['largest_z']:.1f}")
            if one["verdict"] == "not explained":
                found.append(f"{name}: the slope is {one['slope']:.3f}, theory says {one['theory']}")
    found += [f"accelerators, {row['structure']}: {row['wrong']:.0f} wrong answers" for row in report["accelerators"] if row["wrong"]]
    found += [f"stability: {case} fails" for group in report["stability"] for case in group["failed"]]
    return found
