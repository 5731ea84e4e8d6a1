# SPDX-License-Identifier: MIT
"""./lab explain and ./lab heat: is what is explained the picture's own pixel, do the weights keep the laws, is the page whole?

explain_test.py FOLDER: the folder of the programs lab03_solution_explain, lab03_untold and so on."""

import contextlib
import html.parser
import io
import json
import os
import pathlib
import re
import stat
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import labs  # noqa: E402
import machine  # noqa: E402
import pictures  # noqa: E402
import process  # noqa: E402
import student  # noqa: E402
from commands import explain, heat as heat_command  # noqa: E402
from explaining import heat, page, program, sides, text  # noqa: E402

PROGRAMS = pathlib.Path()


def asked(name: str, *words: str):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "answer.json"
        subprocess.run([str(PROGRAMS / name), *words, str(file)], check=True, stdout=subprocess.DEVNULL)
        return json.loads(file.read_text(encoding="utf-8"))["answer"]


def rays(data: dict):
    """Each ray with the ray that it comes from."""
    for sample in data["samples"]:
        for ray in sample["rays"]:
            yield ray, sample["rays"][ray["parent"]] if ray["parent"] >= 0 else None


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    return [x / dot(a, a) ** 0.5 for x in a]


class Recorded(unittest.TestCase):
    def near(self, a, b, by=2e-6):
        for x, y in zip(a, b):
            self.assertLessEqual(abs(x - y), by, f"{a} and {b}")

    def test_what_listens_changes_no_bit(self):
        for lab, name, every in (("lab03", "lab03.png", 499), ("lab06", "lab06_3_row.png", 997), ("lab06", "lab06_5_frosted.png", 1999)):
            self.assertEqual(asked(f"{lab}_solution_explain", "colors", name, str(every)), asked(f"{lab}_untold", "colors", name, str(every)), name)

    def test_the_samples_make_the_pixel_and_the_pixel_is_the_pictures(self):
        for lab, name, places in (("lab03", "lab03.png", ((320, 240), (426, 230), (0, 0), (639, 479))), ("lab06", "lab06_3_row.png", ((320, 100), (747, 219))),
                                  ("lab06", "lab06_4_points.png", ((550, 110), (220, 3)))):
            width = next(one["width"] for one in asked(f"{lab}_solution_explain", "list") if one["name"] == name)
            for x, y in places:
                data = asked(f"{lab}_solution_explain", "pixel", name, str(x), str(y))
                self.assertEqual(data["color"], data["again"])
                self.assertTrue(text.same_again(data))
                if y < 4:  # the picture's row 0 and 3, without the recorder
                    self.assertEqual(data["color"], asked(f"{lab}_untold", "colors", name, str(max(y * width + x, 1)))[1 if y or x else 0])

    def test_weights_of_metal_are_powers_of_its_colour(self):
        data = asked("lab06_solution_explain", "pixel", "lab06_3_row.png", "320", "100")
        seen = 0
        for ray, parent in rays(data):
            if parent:
                self.near(ray["weight"], [w * c for w, c in zip(parent["weight"], (0.95, 0.9, 0.8))], 1e-6)
                seen += 1
        self.assertGreater(seen, 50)

    def test_weights_of_glass_are_fresnels(self):
        data = asked("lab03_solution_explain", "pixel", "lab03.png", "300", "200")
        seen = 0
        for ray, parent in rays(data):
            if not parent or ray["why"] not in ("reflected", "refracted") or data["surfaces"][parent["met"]["surface"]]["material"] != "glass":
                continue
            cosine = dot(unit(parent["direction"]), parent["met"]["normal"])
            ratio = 1 / 1.5 if cosine < 0 else 1.5
            a = abs(cosine)
            behind = max(0, 1 - ratio * ratio * (1 - a * a)) ** 0.5
            part = (((ratio * a - behind) / (ratio * a + behind)) ** 2 + ((a - ratio * behind) / (a + ratio * behind)) ** 2) / 2 if behind else 1
            wanted = part if ray["why"] == "reflected" else 0.98 * (1 - part)
            self.near(ray["weight"], [wanted * w for w in parent["weight"]])
            seen += 1
        self.assertGreater(seen, 40)

    def test_what_a_mirror_brings_comes_through_the_rays_behind_it(self):
        for place in ((426, 230), (300, 200)):
            data = asked("lab03_solution_explain", "pixel", "lab03.png", *map(str, place))
            for sample in data["samples"]:
                for i, ray in enumerate(sample["rays"]):
                    below = [one for one in sample["rays"] if one["parent"] == i and one["why"] != "shadow"]
                    if below:
                        self.near(ray["brings"], [sum(one["brings"][k] for one in below) for k in range(3)])

    def test_rays_are_called_what_they_are(self):
        data = asked("lab03_solution_explain", "pixel", "lab03.png", "420", "310")  # the mirror
        kinds = set()
        for ray, parent in rays(data):
            kinds.add(ray["why"])
            if parent is None:
                self.assertEqual(ray["why"], "camera")
                self.near(ray["origin"], data["eye"])
            elif ray["why"] == "shadow":
                self.near([o + d for o, d in zip(ray["origin"], ray["direction"])], data["lamps"][0]["shape"]["numbers"][:3], 1e-5)
                self.assertIn("matt", data["surfaces"][parent["met"]["surface"]]["material"])
            elif data["surfaces"][parent["met"]["surface"]]["material"] == "a mirror":
                n, d = parent["met"]["normal"], unit(parent["direction"])
                self.near(unit(ray["direction"]), [x - 2 * dot(n, d) * y for x, y in zip(d, n)], 1e-5)
                self.assertEqual(ray["why"], "reflected")
            if parent:
                self.assertFalse(text.gap_matters(ray, [parent, {**ray, "parent": 0}]))
        self.assertLessEqual({"camera", "reflected", "shadow"}, kinds)

    def test_a_shadow_rays_light_is_what_its_card_takes_away(self):
        # Straight onto the floor: one shadow ray a sample; without it the ambient light is left.
        data = asked("lab03_solution_explain", "pixel", "lab03.png", "40", "430")
        lit = dark = 0
        for sample in data["samples"]:
            shadow = [ray for ray in sample["rays"] if ray["why"] == "shadow"]
            self.assertEqual(len(shadow), 1)
            rest = [c - b for c, b in zip(sample["color"], shadow[0]["brings"])]
            self.assertTrue(any(max(abs(r - 0.25 * c) for r, c in zip(rest, body)) < 1e-6 for body in ((0.85, 0.7, 0.1), (0.7, 0.07, 0.04))), rest)
            lit += "met" not in shadow[0]
            dark += "met" in shadow[0]
        self.assertEqual((lit, dark), (9, 0))

    def test_paths_carry_what_albedo_says(self):
        # Cosine-distributed bounces off matt walls: the throughput is the product of the albedos, until roulette.
        data = asked("lab12_solution_explain", "pixel", "lab12_8_box.png", "150", "200")
        seen = 0
        for ray, parent in rays(data):
            if ray["why"] != "bounced" or parent["why"] != "camera":
                continue
            self.near(ray["weight"], data["surfaces"][parent["met"]["surface"]]["color"], 1e-5)
            seen += 1
        self.assertGreater(seen, 20)

    def test_rays_keep_their_time(self):
        data = asked("lab08_solution_explain", "pixel", "lab08_4_whole.png", "300", "250")
        for ray, parent in rays(data):
            self.assertTrue(0 <= ray["time"] <= 1)
            if parent:
                self.assertEqual(ray["time"], parent["time"])

    def test_a_tree_is_asked_from_its_root_down(self):
        data = asked("lab10_solution_explain", "pixel", "own_tree", "67", "128")
        for ray, _ in rays(data):
            self.assertEqual((ray["boxes"][0]["node"], ray["boxes"][0]["depth"]), (0, 0))
            entered = {box["node"] for box in ray["boxes"] if box["t"] is not None}
            self.assertGreater(len(ray["boxes"]), 1)
            self.assertLessEqual(len(entered), len(ray["boxes"]))
        levels = asked("lab10_solution_explain", "heat", "own_tree")["levels"]
        self.assertEqual(sum(node["count"] for node in levels["nodes"]), 820)
        self.assertEqual(max(node["depth"] for node in levels["nodes"]) + 1, len(heat.levels(levels)))

    def test_shadow_rays_through_a_tree_are_heard(self):
        data = asked("lab10_solution_explain", "pixel", "lab10_7_shadows.png", "150", "200")
        fates = set()
        for ray, parent in rays(data):
            if parent is None:
                continue
            self.assertEqual(ray["why"], "shadow")
            self.near([o + d for o, d in zip(ray["origin"], ray["direction"])], data["lamps"][0]["shape"]["numbers"][:3], 1e-5)
            self.assertGreater(len(ray["boxes"]), 0)
            fates.add("met" in ray)
            if "met" in ray:
                self.near(ray["brings"], [0, 0, 0], 0)
                self.assertGreaterEqual(max(ray["keeps"]), 0)
            else:
                self.assertGreater(max(ray["brings"]), 0.05)
        self.assertIn(False, fates)

    def test_heat_counts_the_rays_that_are_explained(self):
        data = asked("lab06_solution_explain", "heat", "lab06_3_row.png")
        self.assertEqual(len(data["rays"]), 748 * 220)
        for x, y in ((320, 100), (135, 101), (0, 0)):
            pixel = asked("lab06_solution_explain", "pixel", "lab06_3_row.png", str(x), str(y))
            self.assertEqual(data["rays"][748 * y + x], sum(len(sample["rays"]) for sample in pixel["samples"]))
            self.assertEqual(data["tests"][748 * y + x], sum(count for ray, _ in rays(pixel) for _, _, count in ray["tests"]))
        self.assertEqual(min(data["rays"]), 25)


class Pictures(unittest.TestCase):
    """What is explained is what the lab's own program drew."""

    def test_every_picture_is_the_programs(self):
        for lab in labs.all_labs():
            if not (ROOT / "labs" / lab.folder / "explain.cpp").is_file():
                continue
            with tempfile.TemporaryDirectory() as folder:
                subprocess.run([str(PROGRAMS / f"{lab.name}_solution"), folder], check=True, stdout=subprocess.DEVNULL)
                found = 0
                for one in asked(f"{lab.name}_solution_explain", "list"):
                    file = pathlib.Path(folder) / one["name"]
                    if not file.exists():
                        continue
                    found += 1
                    picture, every = pictures.read(file), 1499
                    self.assertEqual((picture.width, picture.height), (one["width"], one["height"]), one["name"])
                    for k, color in enumerate(asked(f"{lab.name}_solution_explain", "colors", one["name"], str(every))):
                        drawn = picture.pixels[3 * k * every:3 * k * every + 3]
                        # Encoded here in double, there in float: a value on the border may go either way.
                        for value, byte in zip(color, drawn):
                            self.assertLessEqual(abs(255 * encoded(value) - byte), 0.501, f"{one['name']}, pixel {k * every}")
                self.assertGreater(found, 0, lab.folder)

    def test_a_pixel_taken_again_is_the_same(self):
        for lab in labs.all_labs():
            if not (ROOT / "labs" / lab.folder / "explain.cpp").is_file():
                continue
            for one in asked(f"{lab.name}_solution_explain", "list"):
                x, y = one["width"] // 7, one["height"] * 4 // 7
                data = asked(f"{lab.name}_solution_explain", "pixel", one["name"], str(x), str(y))
                self.assertEqual(data["color"], data["again"], one["name"])
                self.assertTrue(any(sample["rays"] for sample in data["samples"]), one["name"])
                for each, parent in rays(data):
                    self.assertFalse(parent is None and each["why"] != "camera", f"{one['name']}: a ray from nowhere")
                page.made(data, one["name"], lab, None)


def encoded(linear: float) -> float:
    x = min(max(linear, 0), 1)
    return 12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055


class Program(unittest.TestCase):
    """How it is told that a program does not answer, with shell scripts for programs."""

    def ask(self, script: str, patience: float = 1):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "program"
            file.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
            file.chmod(file.stat().st_mode | stat.S_IXUSR)
            one = object.__new__(program.Explainer)
            one.lab, one.program = labs.find("06"), file
            return one.ask("list", patience=patience)

    def problem(self, script: str) -> str:
        with self.assertRaises(student.NotYet) as caught:
            self.ask(script)
        return str(caught.exception)

    def test_an_answer_is_read_whatever_the_student_prints(self):
        self.assertEqual(self.ask('echo rubbish; printf \'{"answer": [7]}\' > "$2"'), [7])

    def test_crashes_loops_and_gaps_are_told_as_in_check(self):
        self.assertIn("crashed (memory that is not yours", self.problem("kill -SEGV $$"))
        self.assertIn("exit status 3", self.problem("echo no memory >&2; exit 3"))
        self.assertIn("no memory", self.problem("echo no memory >&2; exit 3"))
        self.assertIn("lab06 step 3".removeprefix("lab06 "), self.problem('printf \'{"gap": "lab06 step 3: the glossy reflection"}\' > "$2"'))
        with unittest.mock.patch.dict(os.environ, {"LANTERN_STEP_SECONDS": "0.3"}):
            self.assertIn("did not finish in 0.3 s", self.problem("sleep 60"))

    def test_a_pixel_outside_is_refused_with_the_rule(self):
        picture = program.Picture("lab06_3_row.png", 748, 220)
        self.assertEqual(program.pixel("747,219", picture), (747, 219))
        for word in ("748,0", "0,220", "-1,0"):
            with self.assertRaisesRegex(process.Misuse, "x goes from 0 to 747.*y from 0 to 219"):
                program.pixel(word, picture)
        for word in ("", "1", "1,2,3", "a,b", "1.5,2"):
            with self.assertRaisesRegex(process.Misuse, "two whole numbers"):
                program.pixel(word, picture)

    def test_pictures_are_known_by_a_part_of_their_name(self):
        one = object.__new__(program.Explainer)
        one.lab = labs.find("06")
        one.pictures = [program.Picture("lab06_3_row.png", 1, 1), program.Picture("lab06_4_points.png", 1, 1)]
        self.assertIs(one.picture(None), one.pictures[0])
        self.assertIs(one.picture("points"), one.pictures[1])
        for word in ("nothing", "lab06"):
            with self.assertRaises(process.Misuse):
                one.picture(word)

    def test_labs_without_rays_say_why(self):
        without = {lab.name: lab for lab in labs.all_labs() if not (ROOT / "labs" / lab.folder / "explain.cpp").is_file()}
        for name, why in program.NOTHING.items():
            with self.assertRaisesRegex(labs.Problem, "nothing to explain: " + re.escape(why)):
                program.Explainer(without.pop(name), False)
        for lab in without.values():  # one that ./lab new made, say
            with self.assertRaisesRegex(labs.Problem, "nothing to explain: it has no explain.cpp"):
                program.Explainer(lab, False)


SPHERE = {"shape": {"kind": "sphere", "numbers": [0, 1, 0, 1, 0, 0, 0, 0, 0]}, "name": "a <ball>", "material": "glass", "color": [0.5, 0.5, 0.5]}


def ray(parent: int, why: str, **more) -> dict:
    return {"parent": parent, "why": why, "gap": 0, "origin": [0, 1, 1], "direction": [0, 0, -1], "range": [0, None], "tests": [[0, None, 1]],
            "brings": [0.1, 0.1, 0.1], **more}


def by_hand() -> dict:
    met = {"t": 4, "point": [0, 1, 1], "normal": [0, 0, 1], "surface": 0}
    one = [ray(-1, "camera", origin=[0, 1, 5], weight=[1, 1, 1], met=met), ray(0, "refracted", weight=[0.9, 0.9, 0.8]), ray(0, "reflected", weight=[0.1, 0.1, 0.1], gap=0.01),
           ray(0, "shadow", range=[0, 1], met=met, brings=[0, 0, 0], keeps=[0.5, 0.5, 0.5])]
    return {"color": [0.2, 0.3, 0.4], "again": [0.2, 0.3, 0.4], "eye": [0, 1, 5], "beyond": "the sky", "floor": 0, "lamps": [], "surfaces": [SPHERE],
            "samples": [{"color": [0.2, 0.3, 0.4], "rays": one}], "around": {"size": [2, 1], "at": [1, 0], "colors": [[0, 0, 0], [0.2, 0.3, 0.4]]}}


class Words(unittest.TestCase):
    def test_the_tree_is_drawn_with_shadows_first(self):
        lines = text.tree(by_hand(), by_hand()["samples"][0])
        self.assertTrue(lines[0].startswith("camera ray meets a <ball> (glass) at (0, 1, 1), t = 4"))
        self.assertTrue(lines[1].startswith("├─ shadow ray is stopped by a <ball> (glass); keeps away 0.5"))
        self.assertTrue(lines[2].startswith("├─ reflected ray meets nothing: the sky; weight 0.1"))
        self.assertTrue(lines[3].startswith("└─ refracted ray meets nothing: the sky; weight (0.9, 0.9, 0.8)"))

    def test_a_ray_that_starts_off_its_surface_is_told(self):
        self.assertIn("starts 0.01 from where the ray before it ended", "\n".join(text.tree(by_hand(), by_hand()["samples"][0])))

    def test_what_brings_next_to_nothing_is_folded(self):
        data = by_hand()
        rays_there = data["samples"][0]["rays"]
        met = rays_there[0]["met"]
        rays_there[2]["met"] = met
        rays_there += [ray(2, "reflected"), ray(2, "refracted", met=met), ray(5, "refracted")]
        self.assertEqual(len(text.tree(data, data["samples"][0], whole=False)), 7)
        rays_there[2]["brings"] = [9e-5, 0, 0]
        folded = text.tree(data, data["samples"][0], whole=False)
        self.assertEqual(len(folded), 5)
        self.assertIn("3 rays, which bring no more", folded[3])
        self.assertEqual(len(text.tree(data, data["samples"][0])), 7)

    def test_what_is_not_a_number_is_told(self):
        data = by_hand()
        data["samples"][0]["rays"][1].update(direction=[None, 0, None], gap=None, brings=[None, None, None])
        data["samples"][0]["color"] = [None, 0.1, 0.2]
        lines = text.tree(text.mend(data), data["samples"][0])
        self.assertIn("its origin or direction is not a number", lines[3])
        self.assertIn("brings not finite", lines[3])
        self.assertIn("(not finite, 0.1, 0.2)", text.told({**data, "samples": data["samples"] * 2}, "title", None))
        page.made(data, "title", labs.find("03"), None)

    def test_code_that_remembers_is_told(self):
        data = {**by_hand(), "again": [0.2, 0.3, 0.5]}
        self.assertIn("remembers something", text.told(data, "title", None))
        self.assertNotIn("remembers something", text.told(by_hand(), "title", None))

    def test_many_samples_fit_on_a_screen(self):
        data = by_hand()
        data["samples"] *= 64
        said = text.told(data, "title", None)
        self.assertLess(len(said.splitlines()), text.LINES + 8)
        self.assertIn("samples more", said)
        self.assertIn("sample 60 of 64", text.told(data, "title", 59))


class Heat(unittest.TestCase):
    def test_the_hottest_is_found_and_white(self):
        one = heat.Map("rays", program.Picture("p", 3, 2), [1, 2, 3, 4, 9, 1])
        self.assertEqual((one.most, one.where, one.least), (9, (1, 1), 1))
        self.assertAlmostEqual(one.mean, 20 / 6)
        drawn = one.drawn().pixels
        self.assertEqual(tuple(drawn[12:15]), heat.COLORS[-1])
        self.assertEqual(drawn[0:3], drawn[15:18])

    def test_one_hot_pixel_leaves_the_others_apart(self):
        one = heat.Map("rays", program.Picture("p", 100, 1), [1, 2] * 49 + [1, 1000])
        self.assertTrue(one.steep)
        self.assertGreater(one.part(2) - one.part(1), 0.05)
        self.assertEqual((one.part(0), one.part(1000)), (0, 1))
        self.assertAlmostEqual(one.part(one.value(0.3)), 0.3)

    def test_a_box_is_seen_where_it_is(self):
        view = {"eye": [0, 0, 5], "target": [0, 0, 0], "vertical_fov": 2 * 0.4636476090008061, "aspect": 1}  # tan = 1/2
        self.assertEqual([round(x, 6) for x in heat.projected([0, 0, 0], view, 100, 100)], [50, 50])
        self.assertEqual([round(x, 6) for x in heat.projected([2.5, 2.5, 0], view, 100, 100)], [100, 0])
        self.assertIsNone(heat.projected([0, 0, 6], view, 100, 100))

    def test_each_level_has_its_boxes_and_the_leaves_above(self):
        def node(number, depth, count):
            return {"number": number, "depth": depth, "count": count, "min": [-1, -1, -1], "max": [1, 1, 1]}
        tree = {"view": {"eye": [0, 0, 5], "target": [0, 0, 0], "vertical_fov": 0.5, "aspect": 2},
                "nodes": [node(0, 0, 0), node(1, 1, 3), node(2, 1, 0), node(3, 2, 1), node(4, 2, 1)]}
        drawn = heat.levels(tree)
        self.assertEqual([words for words, _ in drawn], ["level 0: 1 box", "level 1: 2 boxes, 1 of them leaves", "level 2: 2 boxes, 2 of them leaves"])
        self.assertEqual([svg.count("<path") for _, svg in drawn], [1, 2, 3])
        self.assertEqual(drawn[2][1].count("stroke-opacity"), 1)


# Runs in the page: what a person would see missing, and whether what is pointed at on one side is lit up on the other.
LOOK = """<script>
window.onerror = message => { document.title = 'ERROR ' + message; };
window.onload = () => {
  const problems = [], canvas = document.getElementById('view'), buttons = [...document.querySelectorAll('.ray')];
  const on = () => buttons.filter(b => b.classList.contains('on')).map(b => b.dataset.ray).join();
  const pixels = () => canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  if (!pixels().some(x => x)) problems.push('an empty view');
  const before = pixels().slice();
  const last = buttons[buttons.length - 1];
  last.dispatchEvent(new PointerEvent('pointerenter'));
  if (on() !== last.dataset.ray) problems.push('the tree does not light up');
  if (!pixels().some((x, i) => x !== before[i])) problems.push('the view does not light up');
  if (!document.querySelector('#detail table')) problems.push('no details');
  last.dispatchEvent(new PointerEvent('pointerleave'));
  const box = canvas.getBoundingClientRect();
  let found = new Set();
  for (let y = 4; y < box.height; y += 5) for (let x = 4; x < box.width; x += 5) {
    canvas.dispatchEvent(new PointerEvent('pointermove', { clientX: box.left + x, clientY: box.top + y }));
    if (on()) found.add(on());
  }
  if (!found.size) problems.push('no ray is found in the view');
  canvas.dispatchEvent(new PointerEvent('pointerleave'));
  const straight = pixels().slice();
  canvas.focus();
  canvas.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft', bubbles: true }));
  if (!pixels().some((x, i) => x !== straight[i])) problems.push('keys do not turn it');
  if (document.querySelectorAll('.sides svg').length !== 3) problems.push('not three sides');
  if (document.documentElement.scrollWidth > document.documentElement.clientWidth + 1) problems.push('the page is wider than the window');
  document.title = 'SEEN ' + buttons.length + ' ' + found.size + ' ' + problems.join('; ');
};
</script>"""

LOOK_AT_HEAT = """<script>
window.onerror = message => { document.title = 'ERROR ' + message; };
window.onload = () => {
  const problems = [], heat = document.querySelector('.heat'), box = heat.getBoundingClientRect();
  heat.dispatchEvent(new PointerEvent('pointermove', { clientX: box.left + .5 * box.width, clientY: box.top + .75 * box.height }));
  if (document.querySelector('output').textContent !== 'Pixel 1,1: 9') problems.push(document.querySelector('output').textContent);
  document.getElementById('down').click();
  if ([...document.querySelectorAll('.level')].map(f => +f.hidden).join('') !== '10') problems.push('levels');
  if (document.documentElement.scrollWidth > document.documentElement.clientWidth + 1) problems.push('the page is wider than the window');
  document.title = 'SEEN ' + problems.join('; ');
};
</script>"""


class Tags(html.parser.HTMLParser):
    """Complains about tags that do not close, or close what is not open."""
    VOID = {"meta", "img", "br", "link", "input"}

    def __init__(self):
        super().__init__()
        self.open, self.problems = [], []

    def handle_starttag(self, tag, attributes):
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.problems.append(f"</{tag}> at {self.getpos()}")


class Pages(unittest.TestCase):
    def whole(self, made: str) -> None:
        tags = Tags()
        tags.feed(made)
        self.assertEqual((tags.problems, tags.open), ([], []))
        for address in re.findall(r'(?:src|href)="([^"]*)"', made):
            self.assertTrue(address.startswith("data:image/png;base64,"), address[:80])

    def title_after(self, made: str, script: str, width: int) -> str:
        browser = machine.browser()
        if browser is None:
            self.skipTest("no Chromium here")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "page.html"
            file.write_text(made.replace("</body>", script + "</body>"), encoding="utf-8")
            done = subprocess.run([browser, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                                   "--disable-background-networking", "--disable-component-update", "--disable-sync", f"--user-data-dir={folder}/profile",
                                   f"--window-size={width},900", "--virtual-time-budget=5000", "--dump-dom", file.as_uri()],
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
        found = re.search(r"<title>(.*?)</title>", done.stdout)
        return found.group(1) if found else "nothing"

    def test_the_page_is_whole_and_shows_the_tree_and_the_view(self):
        data = asked("lab03_solution_explain", "pixel", "lab03.png", "320", "240")
        for one in (data, by_hand()):
            self.whole(page.made(one, "a </script> title", labs.find("03"), None))
        self.assertNotIn("a <ball>", page.made(by_hand(), "t", labs.find("03"), None))
        made = page.made(data, "Lab 03", labs.find("03"), 2)
        for width in (1200, 500):
            seen = self.title_after(made, LOOK, width).split(" ", 3)
            self.assertEqual((seen[0], seen[1], seen[3:]), ("SEEN", str(len(data["samples"][2]["rays"])), [""]), f"{width}: {seen}")
            self.assertGreater(int(seen[2]), 5, "rays found in the view")

    def test_the_page_of_heat_is_whole(self):
        one = heat.Map("rays", program.Picture("p", 3, 2), [1, 2, 3, 4, 9, 1])
        made = heat.page("a <title>", "./lab explain", "your", [one], 9, [("level 0", "<svg></svg>"), ("level 1", "<svg></svg>")])
        self.whole(made)
        for width in (1200, 500):
            self.assertEqual(self.title_after(made, LOOK_AT_HEAT, width), "SEEN ")

    def test_three_sides_hold_every_ray(self):
        data = asked("lab03_solution_explain", "pixel", "lab03.png", "320", "240")
        drawn = sides.views(data, data["samples"][0])
        self.assertEqual(len(re.findall(r'stroke-width="1.5"', drawn)), 3 * len(data["samples"][0]["rays"]))


class Commands(unittest.TestCase):
    """The commands from beginning to end, with the solution's programs and a folder of its own for what they write."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for patch in (unittest.mock.patch.object(explain, "ROOT", self.root), unittest.mock.patch.object(heat_command, "ROOT", self.root),
                      unittest.mock.patch.object(student, "built", lambda lab, kind, solution: PROGRAMS / f"{lab.name}_solution{kind}")):
            patch.start()
            self.addCleanup(patch.stop)

    def said(self, command, *words: str) -> str:
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            self.assertEqual(command.run(list(words)), 0)
        return out.getvalue()

    def test_explain_prints_and_writes(self):
        said = self.said(explain, "06", "--pixel", "550,110", "--picture", "points", "--sample", "1")
        self.assertIn("Lab 06, lab06_4_points.png, pixel 550,110", said)
        self.assertIn("reflected ray", said)
        self.assertTrue((self.root / "out/explain/lab06_4_points_550_110.html").is_file())
        self.said(explain, "3", "--pixel", "1,2")
        self.assertTrue((self.root / "out/explain/lab03_1_2.html").is_file())

    def test_heat_prints_and_writes(self):
        said = self.said(heat_command, "03")
        self.assertRegex(said, r"rays sent +\d+\.\d +9 +\d+ +\d+,\d+")
        x, y = re.search(r"--pixel (\d+,\d+)", said).group(1).split(",")
        self.assertIn(f"{x},{y}", said)
        self.assertEqual(sorted(file.name for file in (self.root / "out/heat").iterdir()), ["lab03.html", "lab03_rays.png", "lab03_tests.png"])


if __name__ == "__main__":
    PROGRAMS = pathlib.Path(sys.argv[1])
    unittest.main(argv=sys.argv[:1])
