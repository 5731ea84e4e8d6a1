# SPDX-License-Identifier: MIT
"""A picture in parts, one of them killed and rendered again: is it, byte for byte, the picture rendered in one go?

shards.py PROGRAMS"""

import pathlib
import subprocess
import sys
import tempfile
import time

PROGRAMS = pathlib.Path(sys.argv[1])
SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "examples" / "shards.sh"


def run(*words: object, code: int = 0) -> str:
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != code:
        sys.exit(f"exit code {done.returncode} instead of {code}: {' '.join(map(str, words))}\n{done.stdout}")
    return done.stdout


def main() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shard, merge = PROGRAMS / "shard", PROGRAMS / "lantern_merge"
        run(shard, folder / "whole.shard", "--of", 16)
        run(merge, folder / "whole.png", folder / "whole.shard")
        for first, last in ((0, 3), (3, 4)):
            run(shard, folder / f"{first}.shard", "--of", 16, "--samples", f"{first}:{last}")

        # Killed in the middle: no file, and no half of one.
        victim = subprocess.Popen([str(shard), str(folder / "4.shard"), "--of", "16", "--samples", "4:16"])
        time.sleep(0.05)
        victim.kill()
        victim.wait()
        if (folder / "4.shard").exists():
            sys.exit("a killed part left a file")
        text = run(merge, folder / "early.png", *(folder / f"{k}.shard" for k in (0, 3)), code=1)
        if "samples 4:16 of 16 are in none" not in text or (folder / "early.png").exists():
            sys.exit(f"a picture with missing samples should be refused, and be told which: {text}")
        run(merge, folder / "early.pfm", *(folder / f"{k}.shard" for k in (0, 3)), "--partial")

        run(shard, folder / "4.shard", "--of", 16, "--part", "0/1")
        text = run(merge, folder / "twice.png", *(folder / f"{k}.shard" for k in (0, 3, 4)), code=2)
        if "samples" not in text:
            sys.exit(f"samples in two parts should be refused: {text}")
        run(shard, folder / "4.shard", "--of", 16, "--samples", "4:16")
        run(merge, folder / "merged.shard", *(folder / f"{k}.shard" for k in (4, 0, 3)))
        run(merge, folder / "merged.png", folder / "merged.shard")
        for kind in ("png", "shard"):
            if (folder / f"merged.{kind}").read_bytes() != (folder / f"whole.{kind}").read_bytes():
                sys.exit(f"merged.{kind} is not whole.{kind}")

        # The engine: five parts, of which one is lost and rendered again.
        run("sh", SCRIPT, PROGRAMS, folder / "engine", 5)
        first = (folder / "engine" / "picture.png").read_bytes()
        (folder / "engine" / "part-3.shard").unlink()
        run("sh", SCRIPT, PROGRAMS, folder / "engine", 5)
        run(shard, folder / "all.shard")
        run(merge, folder / "all.png", folder / "all.shard")
        if not first == (folder / "engine" / "picture.png").read_bytes() == (folder / "all.png").read_bytes():
            sys.exit("the engine's picture is not the one rendered in one go")
        print("the parts are the whole")


main()
