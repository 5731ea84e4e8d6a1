# SPDX-License-Identifier: MIT
"""Configuring and building this checkout."""

import pathlib

import machine
import process
from labs import Problem
from process import ROOT


def configure(preset: str, tests: bool) -> pathlib.Path:
    """Configures build/<preset> and returns it. Once configured with tests, it keeps them."""
    folder = ROOT / "build" / preset
    cache = folder / "CMakeCache.txt"
    if cache.is_file() and not (folder / "build.ninja").is_file():
        cache.unlink()  # a configuration that was interrupted, or by another generator
    with_tests = tests or (cache.is_file() and "LANTERN_TESTS:BOOL=ON" in cache.read_text(encoding="utf-8", errors="replace"))
    if _is_current(folder, with_tests):
        return folder
    switch = "ON" if with_tests else "OFF"
    command = ["cmake", "--preset", preset, f"-DLANTERN_TESTS={switch}", f"-DLANTERN_LABS={switch}"]
    if preset == "clang":
        compiler = machine.clang()
        if not compiler:
            raise Problem("there is no Clang here; ./lab setup --ci brings one")
        command.append(f"-DCMAKE_CXX_COMPILER={compiler}")
    process.need(command, cwd=ROOT)
    return folder


def has_target(folder: pathlib.Path, name: str) -> bool:
    """Whether a configured tree has this target: some are for one compiler alone."""
    return f"build {name}: phony" in (folder / "build.ninja").read_text(encoding="utf-8", errors="replace")


def build(folder: pathlib.Path, *targets: str) -> None:
    process.need(["cmake", "--build", str(folder)] + (["--target", *targets] if targets else []))


def _is_current(folder: pathlib.Path, with_tests: bool) -> bool:
    """Whether the folder is configured as wished: the build itself then notices changed CMake files."""
    cache, ninja = folder / "CMakeCache.txt", folder / "build.ninja"
    if not cache.is_file() or not ninja.is_file():
        return False
    if ninja.stat().st_mtime < (ROOT / "CMakePresets.json").stat().st_mtime:
        return False
    text = cache.read_text(encoding="utf-8", errors="replace")
    return f"LANTERN_TESTS:BOOL={'ON' if with_tests else 'OFF'}" in text
