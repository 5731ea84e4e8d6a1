# SPDX-License-Identifier: MIT
"""A lab's hints: for each step a nudge, then the idea, then nearly the code."""

import json

from labs import ROOT, Lab, Problem

LEVELS = ["a nudge", "the idea", "nearly the code"]


def file_of(lab: Lab):
    return ROOT / "labs" / lab.folder / "hints.json"


def of(lab: Lab) -> list[list[str]]:
    """For each step its hints, as many as there are LEVELS; no list where the lab has none yet."""
    path = file_of(lab)
    if not path.is_file():
        return []
    try:
        steps = json.loads(path.read_text(encoding="utf-8"))["steps"]
        texts = [list(map(str, step)) for step in steps]
    except (ValueError, KeyError, TypeError) as error:
        raise Problem(f"{path.relative_to(ROOT)} cannot be read: {error}") from error
    if len(texts) != len(lab.steps) or any(len(step) != len(LEVELS) for step in texts):
        raise Problem(f"{path.relative_to(ROOT)} must have {len(LEVELS)} hints for each of the {len(lab.steps)} steps of {lab.folder}")
    return texts
