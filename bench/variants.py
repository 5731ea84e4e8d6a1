# SPDX-License-Identifier: MIT
"""variants.py [--check] [--json] COMPILER [OPTION...]: what each variant of a renderer costs to compile, and its size.

The scene is that of the leave-out tests, tests/support/trim_scene.hpp: a kernel for each set of effects, with the types
that `trim` would choose, then one that has everything, then `trim` itself with all its kernels. Printed are seconds of
processor time for the compiler beyond what reading the headers takes, and bytes of machine code in the object file.

    cmake --build build/release --target variants
"""

import json
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

SOURCE = """
#include "trim_scene.hpp"
#include <lantern/distribution.hpp>
#include <lantern/image.hpp>
#include <lantern/render.hpp>
#include <lantern/sky.hpp>
using namespace lantern;
template <class Structure, class Things, class Lights, class Camera>
image picture(const Structure& structure, const Things& things, const Lights& lights, const Camera& cam) {
    const distribution tracer{structure, things, lights, sky{}};
    return render({64, 64}, cam, jittered{}, tracer);
}
"""

KERNEL = "image wanted(const every& all, const std::vector<object<%s, std::variant<%s>>>& things, const std::vector<%s>& lights, const camera<%s>& cam) { return picture(all, things, lights, cam); }"

#           shape, material, light, camera
VARIANTS = {
    "nothing": None,  # the headers alone
    "pinhole, still": ("sphere", "diffuse, mirror", "point_light", "pinhole"),
    "lens": ("sphere", "diffuse, mirror", "point_light", "thin_lens"),
    "motion": ("any_of<sphere, moving<sphere>>", "diffuse, mirror", "point_light", "pinhole, shutter"),
    "gloss": ("sphere", "diffuse, mirror, glossy", "point_light", "pinhole"),
    "soft shadows": ("sphere", "diffuse, mirror", "sphere_light", "pinhole"),
    "all that is asked for": ("any_of<sphere, moving<sphere>>", "diffuse, mirror, glossy", "sphere_light", "thin_lens, shutter"),
    "everything": ("any_of<sphere, moving<sphere>>", "diffuse, mirror, glossy", "std::variant<point_light, sphere_light>", "thin_lens, shutter"),
    "trim, 24 kernels": "image wanted(const trim_scene::everything& s) { return trim(s, [](const auto&... parts) { return picture(parts...); }); }",
}


def measure(source: str, compiler: list[str]) -> tuple[float, int]:
    """Seconds of processor time, and bytes of code."""
    with tempfile.TemporaryDirectory() as folder:
        file, compiled = pathlib.Path(folder, "variant.cpp"), pathlib.Path(folder, "variant.o")
        file.write_text(source, encoding="utf-8")
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([*compiler, "-c", str(file), "-o", str(compiled)], check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        listing = subprocess.run(["size", "-A", str(compiled)], capture_output=True, text=True, check=True).stdout
    code = sum(int(found[1]) for found in re.finditer(r"^\.text\S*\s+(\d+)", listing, re.MULTILINE))
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, code


def main() -> int:
    arguments = sys.argv[1:]
    check = "--check" in arguments  # two variants, to see that this program still works
    as_json = "--json" in arguments
    compiler = [a for a in arguments if a not in ("--check", "--json")]
    wanted = ("nothing", "pinhole, still", "all that is asked for") if check else tuple(VARIANTS)
    rows = []
    headers = 0.0
    for name in wanted:
        variant = VARIANTS[name]
        kernel = variant if isinstance(variant, str) else KERNEL % variant if variant else ""
        seconds, code = measure(SOURCE + kernel + "\n", compiler)
        if name == "nothing":
            headers = seconds
            continue
        rows.append({"variant": name, "seconds": round(seconds - headers, 2), "bytes": code})
    if as_json:
        print(json.dumps({"compiler": compiler, "headers": round(headers, 2), "variants": rows}, indent=2))
    else:
        print(f"reading the headers takes {headers:.2f} s\n\n{'variant':24}{'seconds':>9}{'bytes of code':>15}")
        for row in rows:
            print(f"{row['variant']:24}{row['seconds']:9.2f}{row['bytes']:15,d}")
    if check and not 0 < rows[0]["bytes"] < rows[1]["bytes"]:
        print("the variant with fewer effects is not the smaller one")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
