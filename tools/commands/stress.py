# SPDX-License-Identifier: MIT
"""The stability scorecard, and what robust formulas cost."""

import contextlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import machine
import process
import project
from commands.bench import everything_on_stderr
from labs import Problem

SUMMARY = "stiff and extreme cases: the scorecard of the library, and its price"
USAGE = "stress [--json] [OPTION...]"

# A formula, the cases that judge it, and the inputs that stress_price makes: 4096.
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
CALLS = 4096


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("--json", action="store_true", help="for machines: the cases alone, nothing else on stdout")
    parser.add_argument("--student", action="store_true", help="your lab 14 instead of the library: what it has, the rest is n/a")
    parser.add_argument("--solution", action="store_true", help="the solution of lab 14")
    parser.add_argument("--no-price", action="store_true", help="the scorecard alone")
    parser.add_argument("options", nargs="...", metavar="OPTION",
                        help="handed to the program: --list, --strict, --adapter textbook, --mutant NAME, --group NAME, --case ID, ...")
    wish, unknown = parser.parse_known_args(arguments)
    options = unknown + wish.options
    whose = "stress_student" if wish.student else "stress_solution" if wish.solution else ""
    if whose and options:
        raise Problem(f"with {'--student' if wish.student else '--solution'} there is only --json; what is '{options[0]}'?")
    with everything_on_stderr() if wish.json else contextlib.nullcontext():
        machine.ensure("build")
        if not wish.json and not wish.no_price and not options:
            bring_valgrind()
        folder = project.configure("release", tests=True)
        project.build(folder, *([whose] if whose else ["stress", "stress_price"]))
    program = folder / "tests" / "stress" / (whose or "stress")
    status = subprocess.run([str(program), *(["--json"] if wish.json else []), *options], stdin=subprocess.DEVNULL, check=False).returncode
    if not wish.json and not wish.no_price and not options and not whose and status != 2:
        sys.stdout.flush()
        print(price_table(program, program.parent / "stress_price"))
    return status


def bring_valgrind() -> None:
    """It counts instructions. Where it cannot be had, times will do."""
    try:
        machine.ensure("price")
    except Problem as problem:
        print(f"valgrind cannot be had here ({problem}): times will be shown for counts of instructions")


def price_table(stress: pathlib.Path, price: pathlib.Path) -> str:
    """Error and cost of the textbook's formulas beside ours."""
    errors = {who: errors_of(stress, who) for who in ("textbook", "library")}
    counted = instructions(price)
    unit = "instructions" if counted else "nanoseconds"
    costs = counted or nanoseconds(price)
    lines = [f"what it costs: the textbook's formula in float, and ours, on everyday inputs, half of them hits ({unit} a call)", "",
             f"{'':<12}{'textbook: wrong':>16}{'ulp max':>10}{unit:>14}    {'ours: wrong':>12}{'ulp max':>10}{unit:>14}{'ratio':>8}"]
    for name in PRICED:
        wrong, ulp = errors["textbook"][name]
        our_wrong, our_ulp = errors["library"][name]
        textbook, ours = costs[f"price_{name}_textbook"], costs[f"price_{name}_ours"]
        lines.append(f"{name:<12}{wrong:>16}{ulp:>10.3g}{textbook:>14.0f}    {our_wrong:>12}{our_ulp:>10.3g}{ours:>14.0f}{ours / textbook:>8.2f}")
    lines += ["", "wrong: decided wrongly, or not finite, in the cases of that group; ulp: of the float that the answer is rounded to"]
    if not counted:
        lines.append("valgrind is not here, or did not run: these are times, and no two runs agree on them")
    return "\n".join(lines)


def errors_of(stress: pathlib.Path, adapter: str) -> dict[str, tuple[int, float]]:
    """Of each formula: how many answers of its cases are wrong, and the largest error."""
    done = subprocess.run([str(stress), "--json", "--adapter", adapter], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    try:
        cases = json.loads(done.stdout)["cases"]
    except ValueError as error:
        raise Problem(f"{stress.name} gave no answer: {done.stderr}") from error
    table = {}
    for name, beginnings in PRICED.items():
        mine = [case for case in cases if case["verdict"] != "n/a" and case["id"].startswith(tuple(beginnings))]
        table[name] = (sum(case["wrong"] for case in mine), max((case["ulp_max"] for case in mine), default=0.0))
    return table


def instructions(price: pathlib.Path) -> dict[str, float]:
    """Of each function, how many instructions a call takes, by callgrind; nothing where there is none."""
    valgrind = shutil.which("valgrind")
    if not valgrind:
        return {}
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "callgrind.out"
        done = subprocess.run([valgrind, "--tool=callgrind", f"--callgrind-out-file={out}", str(price), "once"], stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        if done.returncode != 0 or not out.is_file():
            return {}
        return {name: cost / CALLS for name, cost in called(out.read_text(encoding="utf-8")).items() if name.startswith("price_")}


def called(profile: str) -> dict[str, int]:
    """Inclusive costs of the functions called, from a callgrind profile: `cfn=` names one, and below `calls=` stands its cost."""
    names: dict[str, str] = {}
    costs: dict[str, int] = {}
    callee, expected = "", False
    for line in profile.splitlines():
        if match := re.match(r"c?fn=\((\d+)\)(?: (.*))?$", line):
            name = names.setdefault(match[1], match[2] or "")
            if line.startswith("cfn="):
                callee = name
        elif line.startswith("calls="):
            expected = True
        elif expected:
            costs[callee] = costs.get(callee, 0) + int(line.split()[1])
            expected = False
    return costs


def nanoseconds(price: pathlib.Path) -> dict[str, float]:
    done = subprocess.run([str(price)], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=True)
    return {name: float(value) for name, value in (line.split() for line in done.stdout.splitlines()) if name.startswith("price_")}
