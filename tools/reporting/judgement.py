# SPDX-License-Identifier: MIT
"""A student's curves beside ours: what they mean, in words."""

import functools
import math

ALARM = 2.5e-5   # how often noise alone is taken for a bias
SURE = 6         # standard deviations of the pixels' biases, which noise passes as seldom
SLOW = 0.08      # of a slope: with 16 trials it is known within about ±.02
AS_GOOD = 1.15   # times our RMSE at equal samples

# From the best to the worst.
KINDS = ["better", "sound", "worse", "slow", "biased", "repeats", "broken", "gap"]
GOOD = {"better", "sound"}
ENDS = {"time": "it did not end in time", "crash": "it crashed", "threw": "it threw an exception", "gap": "not written yet", "early": "it ended too early"}


def in_figures(z: float) -> str:
    return "> 999" if z >= 999 else f"= {z:.0f}"


@functools.cache
def limit(trials: int) -> float:
    """What |z| of the mean passes with the probability ALARM by chance: with 16 trials 6.0. It has Student's distribution with
    trials - 1 degrees of freedom (Abramowitz and Stegun 26.7.3 and 4)."""
    freedom = trials - 1

    def within(t: float) -> float:
        angle = math.atan(t / math.sqrt(freedom))
        cosine, odd = math.cos(angle), freedom % 2 == 1
        total = term = cosine if odd else 1.0
        for k in range(3 if odd else 2, freedom - 1, 2):
            term *= cosine ** 2 * ((k - 1) / k)
            total += term
        if odd:
            return 2 / math.pi * (angle + (math.sin(angle) * total if freedom > 1 else 0))
        return math.sin(angle) * total

    low, high = 0.0, 1e6
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if 1 - within(middle) > ALARM else (low, middle)
    return high


def is_biased(row: dict, trials: int) -> bool:
    return abs(row["z"]) >= limit(trials) or row["pixel_z"] >= SURE


def number(x: float, pattern: str = "{:.2f}") -> str:
    return pattern.format(x).replace("-", "−")


def judge(one: dict, ours: dict) -> tuple[str, str]:
    """One curve beside ours of the same picture: a kind, and sentences."""
    end = one["end"]
    if end["kind"] == "gap":
        return "gap", f"Still to do: {end['says']}."
    stopped = ended(one)
    if not one["rows"]:
        return "broken", stopped or "There is nothing to measure."
    found = [trouble for trouble in (not_finite(one), outside(one)) if trouble]
    kind, words = read(one, ours)
    if stopped:
        return "broken", " ".join([f"{stopped} As far as it came: {words[0].lower() + words[1:]}", *found])
    if found and kind not in ("biased", "repeats"):
        return "biased", " ".join([*found, f"But for that: {words[0].lower() + words[1:]}"])
    return kind, " ".join([words, *found])


def read(one: dict, ours: dict) -> tuple[str, str]:
    """What the figures say, in the order in which lab 13 asks."""
    rows = one["rows"]
    if all(abs(row["z"]) > 900 or row["rmse_low"] == row["rmse_high"] for row in rows):
        return "repeats", "Every rendering is the same, whatever the seed: nothing is left to chance, and more renderings do not help."
    off = [row for row in rows if is_biased(row, one["trials"])]
    if off:
        worst = max(off, key=bias_z)
        text = (f"Biased: z {in_figures(bias_z(worst))} at {worst['samples']} samples a pixel. The pixels are off by {worst['pixel_bias']:.2g} "
                f"on average, and no number of renderings will mend that.")
        squares = [row for row in rows if is_square(row["samples"])]
        if len(squares) < len(rows) and all(not is_square(row["samples"]) for row in off):
            text += " Where the number of samples is a square nothing is wrong: look at the numbers that are none."
        return "biased", text
    if one["slope"] is None or ours["slope"] is None:
        return "sound", "No bias; too few numbers of samples for a slope."
    slope = f"slope {with_interval(one)}, ours {number(ours['slope'])}"
    if one["slope"] - aside(one) > ours["slope"] + SLOW / 2 and one["slope"] > ours["slope"] + SLOW:
        mine, theirs = one["half_error_costs"], ours["half_error_costs"]
        cost = f"half the error costs {mine:.1f} times the time, and ours {theirs:.1f} times" if mine and theirs else "the error hardly falls"
        return "slow", f"No bias, but slow: {slope}; {cost}. The strata are lost somewhere."
    ratio, at = beside(rows, ours)
    if ratio is None:
        return "sound", f"No bias; {slope}."
    equal = f"at {at} samples the error is {number(ratio)} times ours"
    if ratio > AS_GOOD:
        return "worse", f"No bias; {slope}; but {equal}."
    if ratio < 1 / AS_GOOD:
        return "better", f"No bias; {slope}; {equal}."
    return "sound", f"Right, and as good as ours: no bias, {slope}; {equal}."


def ended(one: dict) -> str:
    """Where and why the points came to an end; nothing where they did not."""
    end = one["end"]
    if not end["kind"]:
        return ""
    where = f"after {one['rows'][-1]['samples']} samples a pixel" if one["rows"] else "before the first picture was done"
    return f"{ENDS[end['kind']].capitalize()} {where}" + (f": {end['says'].rstrip('.')}." if end["says"] else ".")


def not_finite(one: dict) -> str:
    return f"{one['not_finite']} values are not finite." if one["not_finite"] else ""


def outside(one: dict) -> str:
    if not one["outside"]:
        return ""
    return f"{one['outside']:,} of {one['points']:,} points lie outside the unit square.".replace(",", " ")


def bias_z(row: dict) -> float:
    """The larger of both: of the mean over the picture, and of the pixels by themselves."""
    return max(abs(row["z"]), row["pixel_z"])


def with_interval(one: dict) -> str:
    """The slope, with as many decimals as its interval deserves."""
    pattern = "{:.3f}" if aside(one) < 0.0095 else "{:.2f}"
    return f"{number(one['slope'], pattern)} ± {number(aside(one), pattern)}"


def aside(one: dict) -> float:
    return max(one["slope_high"] - one["slope"], one["slope"] - one["slope_low"])


def beside(rows: list[dict], ours: dict) -> tuple[float | None, int]:
    """RMSE over ours, at the largest number of samples that both have."""
    known = {row["samples"]: row["rmse"] for row in ours["rows"]}
    both = [row for row in rows if row["samples"] in known]
    return (both[-1]["rmse"] / known[both[-1]["samples"]], both[-1]["samples"]) if both else (None, 0)


def is_square(n: int) -> bool:
    return round(n ** 0.5) ** 2 == n


def worst(entry: dict) -> str:
    """The worst kind of an entry's curves."""
    if entry["message"]:
        return "broken"
    return max((one["kind"] for one in entry["curves"]), key=KINDS.index, default="broken")


def headline(entry: dict) -> str:
    """One sentence or two for all pictures."""
    if entry["message"]:
        return entry["message"].splitlines()[0].replace(" The first error:", "")
    curves: list[dict] = entry["curves"]
    kind = worst(entry)
    if kind in GOOD:
        return f"Sound in all {len(curves)} pictures: no bias, and as good as ours or better."
    bad = [one for one in curves if one["kind"] == kind]
    patterns = {each["pattern"] for each in curves}
    where = ", ".join(dict.fromkeys(one["effect"] if len(patterns) == 1 else f"{one['effect']} ({one['pattern']})" for one in bad))
    words = {"worse": "A larger error than ours", "slow": "Slow", "biased": "Biased", "repeats": "The seed does nothing", "broken": "Broken", "gap": "Still to do"}
    if len(curves) == 1 and curves[0]["end"]["kind"] == "time":
        return f"{words[kind]}. {ended(curves[0])} The other pictures were not tried."
    text = f"{words[kind]} in " + (f"all {len(curves)} pictures." if len(bad) == len(curves) else f"{len(bad)} of {len(curves)} pictures: {where}.")
    if kind in ("broken", "gap"):
        text += " " + (ended(bad[0]) if kind == "broken" else f"{bad[0]['end']['says'].rstrip('.')}.")
    if kind in ("biased", "slow", "worse") and [one["effect"] for one in bad] == ["two effects at once"]:
        text += " Each effect alone comes out right: what the two purposes draw must have something to do with each other."
    if kind == "biased":
        largest = max((row for one in bad for row in one["rows"] if is_biased(row, one["trials"])), key=bias_z, default=None)
        text += f" At worst z {in_figures(bias_z(largest))}." if largest else " Some points lie outside the unit square, or are no numbers."
    return text


def in_short(entry: dict) -> str:
    """A few words, for a line of progress, before ours are known."""
    if entry["message"]:
        return "not measured: " + entry["message"].splitlines()[0][:70]
    trouble = [ENDS[one["end"]["kind"]] for one in entry["curves"] if one["end"]["kind"]]
    return trouble[0] if trouble else "measured"
