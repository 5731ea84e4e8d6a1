# SPDX-License-Identifier: MIT
"""The stability scorecard, and what robust formulas cost."""

import contextlib
import json
import pathlib
import subprocess
import sys

import machine
import prices
import process
import project
from commands.bench import everything_on_stderr
from labs import Problem

SUMMARY = "stiff and extreme cases: the scorecard of the library, and its price"
USAGE = "stress [--json] [OPTION...]"


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
    counted = prices.counted(price)
    unit = "instructions" if counted else "nanoseconds"
    lines = [f"what it costs: the textbook's formula in float, and ours, on everyday inputs, half of them hits ({unit} a call)", "",
             f"{'':<12}{'textbook: wrong':>16}{'ulp max':>10}{unit:>14}    {'ours: wrong':>12}{'ulp max':>10}{unit:>14}{'ratio':>8}"]
    for row in prices.table(cases_of(stress, "textbook"), cases_of(stress, "library"), counted or prices.timed(price)):
        lines.append(f"{row['formula']:<12}{row['textbook_wrong']:>16}{row['textbook_ulp_max']:>10.3g}{row['textbook_cost']:>14.0f}    "
                     f"{row['ours_wrong']:>12}{row['ours_ulp_max']:>10.3g}{row['ours_cost']:>14.0f}{row['ratio']:>8.2f}")
    lines += ["", "wrong: decided wrongly, or not finite, in the cases of that group; ulp: of the float that the answer is rounded to"]
    if not counted:
        lines.append("valgrind is not here, or did not run: these are times, and no two runs agree on them")
    return "\n".join(lines)


def cases_of(stress: pathlib.Path, adapter: str) -> list[dict]:
    done = subprocess.run([str(stress), "--json", "--adapter", adapter], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    try:
        return json.loads(done.stdout)["cases"]
    except ValueError as error:
        raise Problem(f"{stress.name} gave no answer: {done.stderr}") from error
