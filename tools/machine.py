# SPDX-License-Identifier: MIT
"""What this machine has, what Lantern needs of it, and how it is brought."""

import hashlib
import os
import re
import shutil
import sys
from dataclasses import dataclass, field

import process
from labs import Problem
from process import ROOT

# What each part of the work needs, and the part that it stands on.
NEEDS = {
    "build": ["compiler", "cmake", "ninja", "glm", "stb"],
    "test": ["catch2"],
    "grade": ["bubblewrap"],
    "ci": ["clang", "tinyobj", "fuzzer", "matplotlib", "valgrind", "chromium"],
    "bench": ["embree", "matplotlib", "npm"],
    "price": ["valgrind"],
    "report": ["matplotlib", "valgrind"],
}
STANDS_ON = {"test": "build", "grade": "test", "ci": "grade", "bench": "build", "report": "test"}

PACKAGES = {
    "apt": {"compiler": "g++", "cmake": "cmake", "ninja": "ninja-build", "glm": "libglm-dev", "stb": "libstb-dev",
            "catch2": "catch2", "bubblewrap": "bubblewrap", "clang": "clang-16", "tinyobj": "libtinyobjloader-dev",
            "fuzzer": "libclang-rt-16-dev", "valgrind": "valgrind", "embree": "libembree-dev",
            "matplotlib": "python3-matplotlib", "npm": "npm", "chromium": "chromium"},
    "dnf": {"compiler": "gcc-c++", "cmake": "cmake", "ninja": "ninja-build", "glm": "glm-devel",
            "stb": "stb_image_write-devel", "catch2": "catch-devel", "bubblewrap": "bubblewrap", "clang": "clang",
            "tinyobj": "tinyobjloader-devel", "fuzzer": "compiler-rt", "valgrind": "valgrind",
            "matplotlib": "python3-matplotlib", "npm": "npm", "chromium": "chromium"},
    "pacman": {"compiler": "gcc", "cmake": "cmake", "ninja": "ninja", "glm": "glm", "stb": "stb", "catch2": "catch2",
               "bubblewrap": "bubblewrap", "clang": "clang", "tinyobj": "tinyobjloader", "fuzzer": "compiler-rt",
               "valgrind": "valgrind", "matplotlib": "python-matplotlib", "npm": "npm", "chromium": "chromium"},
    "brew": {"compiler": "gcc", "cmake": "cmake", "ninja": "ninja", "glm": "glm", "catch2": "catch2", "clang": "llvm",
             "tinyobj": "tinyobjloader", "matplotlib": "python-matplotlib", "npm": "node"},
}

# What we do without where no package brings it: CMake fetches the first three at a pinned commit.
SPARED = {"glm": "CMake will fetch its sources", "stb": "CMake will fetch its sources",
          "catch2": "CMake will fetch its sources", "tinyobj": "<lantern/obj.hpp> is left out",
          "bubblewrap": "./lab grade then refuses what it is not told to trust",
          "fuzzer": "nothing is fuzzed but the kept seeds", "valgrind": "instructions are not counted",
          "embree": "./lab bench trace does without", "matplotlib": "no plots are drawn",
          "npm": "./lab bench trace --dragon does not work", "chromium": "no browser looks at the report"}

MINIMUM = {"cmake": (3, 25)}
CLANGS = ["clang++-16", "clang++", "clang++-20", "clang++-19", "clang++-18", "clang++-17", "clang++-15", "clang++-14"]

# One run of the preprocessor tells the compiler's standard library and the header libraries.
PROBE = """
#if defined(__has_include) && __cplusplus >= 202002L
#if __has_include(<concepts>) && __has_include(<span>)
found_compiler
#endif
#if __has_include(<glm/vec3.hpp>)
found_glm
#endif
#if __has_include(<stb_image_write.h>) || __has_include(<stb/stb_image_write.h>)
found_stb
#endif
#if __has_include(<tiny_obj_loader.h>)
found_tinyobj
#endif
#if __has_include(<embree3/rtcore.h>)
found_embree
#endif
#if __has_include(<catch2/catch_test_macros.hpp>) || __has_include(<catch2/catch.hpp>)
found_catch2
#endif
#endif
"""


@dataclass
class Finding:
    name: str
    found: str = ""  # a version, or where it is; empty when it is missing
    remark: str = ""

    @property
    def missing(self) -> bool:
        return not self.found


@dataclass
class Manager:
    """A package manager, and the commands that bring packages by it."""
    name: str
    install: list[str]
    refresh: list[str] = field(default_factory=list)

    def commands(self, needs: list[str]) -> list[list[str]]:
        packages = [PACKAGES[self.name][need] for need in needs if need in PACKAGES[self.name]]
        if not packages:
            return []
        commands = [self.refresh] if self.refresh else []
        return commands + [self.install + packages]


def manager() -> Manager | None:
    """The package manager of this machine; with sudo unless we are root."""
    sudo = [] if os.geteuid() == 0 else ["sudo"]
    if shutil.which("apt-get"):
        return Manager("apt", sudo + ["env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "install", "-y",
                                      "--no-install-recommends"], sudo + ["apt-get", "update"])
    if shutil.which("dnf"):
        return Manager("dnf", sudo + ["dnf", "install", "-y"])
    if shutil.which("pacman"):
        return Manager("pacman", sudo + ["pacman", "-S", "--needed", "--noconfirm"])
    if shutil.which("brew"):
        return Manager("brew", ["brew", "install"])
    return None


def version(text: str) -> tuple[int, ...]:
    """The first thing in a text that looks like a version."""
    match = re.search(r"\d+(?:\.\d+)+", text)
    return tuple(int(part) for part in match.group().split(".")) if match else ()


def compiler() -> str | None:
    """The compiler that CMake will use."""
    if "CXX" in os.environ:
        return shutil.which(os.environ["CXX"].split()[0])
    return next((path for name in ("c++", "g++", "clang++") if (path := shutil.which(name))), None)


def clang() -> str | None:
    return next((path for name in CLANGS if (path := shutil.which(name))), None)


def plotter() -> str | None:
    """A Python that has matplotlib: this one, or the system's, to which its packages belong."""
    for python in (sys.executable, "/usr/bin/python3"):
        if process.capture([python, "-c", "import matplotlib"])[0] == 0:
            return python
    return None


def browser() -> str | None:
    """A Chromium, for looking at pages without a window."""
    return next((path for name in ("chromium", "chromium-browser", "google-chrome") if (path := shutil.which(name))), None)


def fuzzes(path: str | None) -> bool:
    """Whether this Clang has libFuzzer."""
    source = 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }'
    command = [path or "clang++", "-fsanitize=fuzzer", "-x", "c++", "-", "-o", os.devnull]
    return path is not None and process.capture(command, source)[0] == 0


def look(*levels: str) -> list[Finding]:
    """What was found of all that these levels of work need."""
    findings = []
    needs = list(dict.fromkeys(need for level in levels for need in wanted(level)))
    cxx = compiler()
    probe = process.capture([cxx, "-std=c++20", "-x", "c++", "-E", "-P", "-"], PROBE)[1] if cxx else ""
    for need in needs:
        finding = Finding(need)
        if need == "compiler":
            if cxx:
                name = process.capture([cxx, "--version"])[1].splitlines()[0]
                if "found_compiler" in probe:
                    finding.found = f"{name}"
                else:
                    finding.remark = f"{name} knows too little of C++20"
        elif need in ("cmake", "ninja"):
            path = shutil.which(need)
            if path:
                seen = version(process.capture([path, "--version"])[1])
                text = ".".join(map(str, seen))
                if seen >= MINIMUM.get(need, ()):
                    finding.found = text
                else:
                    finding.remark = f"{text} is too old: {'.'.join(map(str, MINIMUM[need]))} is needed"
        elif need == "bubblewrap":
            if shutil.which("bwrap"):
                finding.found = process.capture(["bwrap", "--version"])[1].strip().removeprefix("bubblewrap ")
        elif need == "clang":
            path = clang()
            if path:
                finding.found = process.capture([path, "--version"])[1].splitlines()[0]
        elif need == "matplotlib":
            finding.found = plotter() or ""
        elif need == "chromium":
            finding.found = browser() or ""
        elif need in ("npm", "valgrind"):
            finding.found = shutil.which(need) or ""
        elif need == "fuzzer":
            finding.found = "found" if fuzzes(clang()) else ""
        elif f"found_{need}" in probe:
            finding.found = "found"
        elif not cxx:
            finding.remark = "cannot be looked for without a compiler"
        findings.append(finding)
    return findings


def wanted(level: str) -> list[str]:
    """All that a level of work needs, after what it stands on."""
    return (wanted(STANDS_ON[level]) if level in STANDS_ON else []) + NEEDS[level]


def ensure(level: str) -> None:
    """Brings what a level of work needs and this machine lacks. Does nothing when all is there."""
    stamp = ROOT / "build" / f".machine-{level}"
    known = _fingerprint()
    if _read(stamp) == known:
        return
    missing = [finding.name for finding in look(level) if finding.missing]
    if missing and (manager() or any(name not in SPARED for name in missing)):
        _install(missing)
    if missing:
        still = [finding for finding in look(level) if finding.missing]
        fatal = [finding for finding in still if finding.name not in SPARED]
        for finding in still:
            if finding not in fatal:
                print(f"{finding.name} is in no package here; {SPARED[finding.name]}")
        if fatal:
            raise Problem("still missing: " + "; ".join(f"{f.name} ({f.remark})" if f.remark else f.name for f in fatal))
    stamp.parent.mkdir(exist_ok=True)
    stamp.write_text(_fingerprint(), encoding="utf-8")


def _install(missing: list[str]) -> None:
    tool = manager()
    if not tool:
        raise Problem("missing: " + ", ".join(missing) + ".\nI know none of this machine's package managers; "
                      "please install them by hand (README.md says which) and try again")
    commands = tool.commands(missing)
    if commands and commands[0][0] == "sudo" and not shutil.which("sudo"):
        lines = "\n".join("  " + " ".join(command[1:]) for command in commands)
        raise Problem(f"missing: {', '.join(missing)}, and there is no sudo. As root, run:\n{lines}")
    for command in commands:
        if process.call(command, terminal=True) != 0:
            raise Problem("that command failed. Mend what it complains about (no network? another installation "
                          "running?), or install these by hand, and try again: " + ", ".join(missing))


def _fingerprint() -> str:
    """Changes when the programs that we found may have changed: then we look again, else a look is spared."""
    parts = [os.environ.get("PATH", ""), os.environ.get("CXX", "")]
    for name in ("c++", "g++", "cmake", "ninja", "bwrap", "npm", *CLANGS):
        path = shutil.which(name)
        parts.append(f"{path} {os.stat(path).st_mtime_ns}" if path else "-")
    for folder in ("/usr/include", "/usr/local/include", "/opt/homebrew/include"):
        for library in ("glm", "stb", "catch2", "tiny_obj_loader.h", "embree3"):
            parts.append(str(os.path.exists(os.path.join(folder, library))))
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def _read(path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except OSError:
        return ""
