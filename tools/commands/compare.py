# SPDX-License-Identifier: MIT
"""Your pictures and ours under a slider, with their signed difference: out/compare/labNN.html."""

import base64
import html
import pathlib
import subprocess
import sys

import pictures
import process
import student
import whole
from labs import ROOT, Problem

SUMMARY = "your pictures and ours under a slider: out/compare/labNN.html"
USAGE = "compare NN"
EXAMPLES = "./lab compare 03"

PAGE = """<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Lab {number}: yours and ours</title>
<meta name="viewport" content="width=device-width, initial-scale=1"><style>
:root {{ color-scheme: light dark; --line: #8886; }}
body {{ font: 16px/1.5 system-ui, sans-serif; max-width: 80rem; margin: 0 auto; padding: 1rem; }}
p {{ max-width: 46rem; }}
.pair {{ position: relative; }}
img {{ display: block; width: 100%; image-rendering: pixelated; border: 1px solid var(--line); }}
.pair .over {{ position: absolute; inset: 0; clip-path: inset(0 0 0 var(--at, 50%)); }}
.pair .line {{ position: absolute; top: 0; bottom: 0; left: var(--at, 50%); border-left: 2px solid #f80; }}
input[type=range] {{ width: 100%; margin: .5rem 0; }}
.row {{ display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 22rem), 1fr)); gap: 1rem; align-items: start; }}
.right {{ color: #1a7f37; }} .wrong {{ color: #d33; }}
</style></head><body><h1>Lab {number}: {title}</h1>
<p>Left of the line yours, right of it ours. In the difference red is where yours is brighter, blue where it is darker, four times as strong as it is;
white is where they agree.</p>{sections}
<script>
for (const slider of document.querySelectorAll('input[type=range]'))
  slider.addEventListener('input', () => slider.previousElementSibling.style.setProperty('--at', slider.value + '%'));
</script></body></html>
"""


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY, EXAMPLES)
    student.takes_a_lab(parser)
    lab = parser.parse_args(arguments).lab
    if not lab.solution_file.exists():
        raise Problem(f"{student.no_solution(lab)} The pictures in {process.shorten(lab.handout)} are ours")
    folder = ROOT / "out" / "compare" / lab.name
    made = {}
    for who, solution in (("ours", True), ("yours", False)):
        try:
            program = student.built(lab, "", solution)
        except student.NotYet as problem:
            print(problem, file=sys.stderr)
            return 1
        made[who] = drawn(program, folder / who)
    page = folder.with_suffix(".html")
    sections, same = "", 0
    for name in made["ours"]:
        text, equal = section(name, made["yours"].get(name), made["ours"][name])
        sections += text
        same += equal
    whole.write(page, PAGE.format(number=lab.number, title=html.escape(lab.title), sections=sections))
    print(f"{same} of {len(made['ours'])} pictures are the same. The page: {process.shorten(str(page))}")
    return 0


def drawn(program: pathlib.Path, folder: pathlib.Path) -> dict[str, pathlib.Path]:
    """The pictures that a lab's program writes, by name."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.iterdir():
        old.unlink()
    try:
        done = subprocess.run([str(program), str(folder)], cwd=ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True,
                              errors="replace", check=False, timeout=120)
    except subprocess.TimeoutExpired as error:
        raise Problem("the lab's program did not finish in two minutes: an endless loop? ./lab check says which step") from error
    if done.returncode != 0:
        print(f"the lab's program ended with exit code {done.returncode}: what it drew before that is compared", file=sys.stderr)
    return {path.name: path for path in sorted(folder.iterdir()) if path.suffix in (".png", ".ppm")}


def section(name: str, yours: pathlib.Path | None, ours: pathlib.Path) -> tuple[str, bool]:
    """One picture of the page, and whether it is the same."""
    title = html.escape(pathlib.Path(name).stem.replace("_", " "))
    reference = pictures.read(ours)
    try:
        mine = pictures.read(yours) if yours else None
    except ValueError:
        mine = None
    if mine is None:
        return f'<h2>{title}</h2><p class="wrong">Your program drew no such picture.</p>{image(reference)}', False
    if (mine.width, mine.height) != (reference.width, reference.height):
        return (f'<h2>{title}</h2><p class="wrong">Yours has {mine.width} × {mine.height} pixels, ours {reference.width} × {reference.height}.</p>'
                f'<div class="row"><div>{image(mine)}</div><div>{image(reference)}</div></div>'), False
    difference, count, most = pictures.signed_difference(mine, reference)
    if count == 0:
        verdict = '<p class="right">The same in every pixel.</p>'
    else:
        part = 100 * count / (mine.width * mine.height)
        shown = f"{part:.0f}" if part >= 1 else f"{part:.2g}"
        verdict = f'<p class="wrong">{shown} % of the pixels differ, by {most} of 255 at the most.</p>'
    pair = (f'<div class="pair">{image(mine)}<div class="over">{image(reference)}</div><div class="line"></div></div>'
            f'<input type="range" min="0" max="100" value="50" aria-label="where yours ends and ours begins">')
    return f'<h2>{title}</h2>{verdict}<div class="row"><div>{pair}</div><div>{image(difference)}</div></div>', count == 0


def image(picture: pictures.Picture) -> str:
    return f'<img alt="" src="data:image/png;base64,{base64.b64encode(pictures.png(picture)).decode()}">'
