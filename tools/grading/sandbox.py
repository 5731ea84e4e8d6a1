# SPDX-License-Identifier: MIT
"""Running what nobody trusts: bubblewrap, an unprivileged user, and limits. Says what holds, after having tried it."""

import functools
import itertools
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from dataclasses import dataclass, field

from labs import ROOT, Problem

MIB = 1 << 20
USERS = range(62100, 62600)  # with root's rights, each slot runs as a user of its own, one of these


@dataclass(frozen=True)
class Limits:
    cpu: int = 40               # seconds, for each process
    wall: float = 60            # seconds, for all of it
    memory: int = 1024 * MIB    # address space of each process; the group's memory where there are control groups
    processes: int = 32
    file_size: int = 64 * MIB   # of each file that is written
    output: int = 256 * 1024    # bytes of what is printed that are kept


@dataclass
class Outcome:
    status: int | None  # None: it did not end in time
    printed: bytes


@dataclass
class Level:
    """What the sandbox was seen to hold. Without isolation nothing untrusted may run in it."""
    isolated: bool
    holds: list[str] = field(default_factory=list)
    lacks: list[str] = field(default_factory=list)
    reason: str = ""  # why bubblewrap does not work

    def __str__(self) -> str:
        text = ("isolated: " if self.isolated else "NOT ISOLATED: ") + ", ".join(self.holds or ["nothing holds"])
        if self.lacks:
            text += "; without: " + ", ".join(self.lacks)
        return text + (f" ({self.reason})" if self.reason else "")


def is_root() -> bool:
    return os.geteuid() == 0


class Group:
    """A control group for one slot: a limit of processes and memory over all that runs in it. Nothing where there is none to be had."""

    def __init__(self, name: str, processes: int, memory: int):
        self.folders: list[pathlib.Path] = []
        for base, limits in _controllers():
            remove_stale(base)
            wanted = {"pids.max": processes, "memory.max": memory, "memory.limit_in_bytes": memory}
            folder = base / name
            try:
                folder.mkdir(exist_ok=True)
                written = 0
                for file in limits:
                    (folder / file).write_text(str(wanted[file]))
                    written += 1
                if written:
                    self.folders.append(folder)
            except OSError:
                continue

    @property
    def limits_processes(self) -> bool:
        return any((folder / "pids.max").exists() for folder in self.folders)

    def entered(self, argv: list[str]) -> list[str]:
        """The command, begun within the group."""
        for folder in self.folders:
            argv = ["/bin/sh", "-c", 'echo 0 >"$0" && exec "$@"', str(folder / "cgroup.procs"), *argv]
        return argv

    def running(self) -> list[int]:
        found = set()
        for folder in self.folders:
            try:
                found |= {int(line) for line in (folder / "cgroup.procs").read_text().split()}
            except OSError:
                pass
        return sorted(found)

    def end_all(self) -> int:
        """Ends what is left in the group, and tells how many that were."""
        left = self.running()
        for _ in range(200):
            now = self.running()
            if not now:
                break
            for pid in now:
                try:
                    os.kill(pid, signal.SIGKILL)
                except (ProcessLookupError, PermissionError):
                    pass
            time.sleep(0.01)
        return len(left)

    def remove(self) -> None:
        self.end_all()
        for folder in self.folders:
            try:
                folder.rmdir()
            except OSError:
                pass
        self.folders = []


@functools.cache
def _controllers() -> list[tuple[pathlib.Path, list[str]]]:
    """Folders in which groups can be made, and the limits that each kind knows."""
    base = pathlib.Path("/sys/fs/cgroup")
    if not is_root():
        return []
    for folder in (base, base / "unified"):
        try:
            there = (folder / "cgroup.controllers").read_text().split()
            wanted = [name for name in ("pids", "memory") if name in there]
            if "pids" in wanted:
                (folder / "cgroup.subtree_control").write_text(" ".join("+" + name for name in wanted))
                return [(folder, [f"{name}.max" for name in wanted])]
        except OSError:
            continue
    version_1 = {"pids": ["pids.max"], "memory": ["memory.limit_in_bytes"]}
    return [(base / name, limits) for name, limits in version_1.items()
            if (base / name / "cgroup.procs").exists() and os.access(base / name, os.W_OK)]


def remove_stale(base: pathlib.Path) -> None:
    """Groups of graders that were killed. One in which something still runs cannot be removed, and stays."""
    for old in base.glob("lantern-*-*"):
        if not os.path.exists(f"/proc/{old.name.split('-')[1]}"):
            try:
                old.rmdir()
            except OSError:
                pass


class Sandbox:
    """One slot, for one submission at a time."""

    _numbers = itertools.count()

    def __init__(self, way: str | None = None):
        self.way = best_way() if way is None else way
        self.user, self.lease = _free_user() if is_root() else (os.geteuid(), None)
        self.group = Group(f"lantern-{os.getpid()}-{next(Sandbox._numbers)}", 48, 2048 * MIB)

    def __enter__(self) -> "Sandbox":
        return self

    def __exit__(self, *_) -> None:
        self.close()

    def close(self) -> None:
        self.end_all()
        self.group.remove()
        if self.lease:
            self.lease.close()

    def end_all(self) -> int:
        """Ends whatever is left in this slot, and tells how many processes that were. Namespaces end with their first process; without
        them, what a user of the slot's own has left is looked for."""
        left = self.group.end_all()
        if self.way == "limits" and is_root():
            for _ in range(100):
                found = [int(each.name) for each in pathlib.Path("/proc").glob("[0-9]*") if _is_of(each, self.user)]
                if not found:
                    break
                left += len(found)
                for number in found:
                    try:
                        os.kill(number, signal.SIGKILL)
                    except ProcessLookupError:
                        pass
                time.sleep(0.02)
        return left

    def own(self, folder: pathlib.Path) -> pathlib.Path:
        """An empty folder that the slot's user may write to."""
        folder.mkdir(mode=0o700)
        if is_root():
            os.chown(folder, self.user, self.user)
        return folder

    def command(self, argv: list[str], limits: Limits, *, readable: dict[str, pathlib.Path] | None = None, writable: dict[str, pathlib.Path] | None = None,
                system: bool = False, folder: str = "/") -> list[str]:
        """What to run for `argv` to run within the limits; it sees the folders and files under the names given, and `system`,
        all of /usr, else its libraries alone. Where there is no bubblewrap it sees everything, under its own name."""
        bounds = ["/usr/bin/prlimit", f"--cpu={limits.cpu}", f"--as={limits.memory}", f"--nproc={limits.processes}",
                  f"--fsize={limits.file_size}", "--core=0", "--nofile=64", "--memlock=65536", "--msgqueue=0"]
        drop = ["/usr/bin/setpriv", f"--reuid={self.user}", f"--regid={self.user}", "--clear-groups", "--no-new-privs"]
        if self.way == "limits":
            names = {**(readable or {}), **(writable or {})}
            argv = [translated(word, names) for word in argv]
            start = ["/usr/bin/env", "-i", "PATH=/usr/bin:/bin", *argv]
            if os.path.exists(bounds[0]):
                if not is_root():  # here all processes of the user count, the grader's own, too
                    bounds = [bound for bound in bounds if not bound.startswith("--nproc")]
                start = (drop if is_root() else []) + [*bounds, *start]
            else:  # macOS
                start = ["/bin/sh", "-c", f'ulimit -t {limits.cpu} -f {limits.file_size // 512}; exec "$@"', "sh", *start]
            return self.group.entered(start)

        own = ["--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts", "--unshare-cgroup-try"]
        inner = [*own, "--die-with-parent", "--new-session", "--clearenv", "--setenv", "PATH", "/usr/bin:/bin",
                 "--setenv", "LC_ALL", "C", *system_mounts(system), "--dir", "/dev", "--dev-bind", "/dev/null", "/dev/null"]
        if system:
            inner += ["--size", str(512 * MIB), "--tmpfs", "/tmp"]
        for name, path in (readable or {}).items():
            inner += ["--ro-bind", str(path), name]
        for name, path in (writable or {}).items():
            inner += ["--bind", str(path), name]
        last = ["--remount-ro", "/", "--chdir", folder, "--"]
        if self.way == "bwrap-by-root":  # where users may make no namespaces: root makes them, and drops its rights inside
            inner += ["--ro-bind-try", bounds[0], bounds[0], "--ro-bind-try", drop[0], drop[0],
                      "--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID", "--cap-add", "CAP_SETPCAP"]
            inner = ["--perms", "0755", "--dir", "/usr", *inner]  # else it is root's alone
            argv = [*drop, "--bounding-set=-all", "--inh-caps=-all", *bounds, *argv]
            return self.group.entered([bubblewrap(), *inner, *last, *argv])
        # Limits of processes are counted for each user namespace: they are set within it, too.
        inner += ["--unshare-user", "--disable-userns"] if knows_disable_userns() else ["--unshare-user"]
        inner += [] if system else ["--ro-bind", bounds[0], bounds[0]]
        start = [bubblewrap(), *inner, *last, *bounds, *argv]
        return self.group.entered((drop if is_root() else []) + start)

    def run(self, argv: list[str], limits: Limits, **mounts) -> Outcome:
        """Runs to the end, or to the limit; what it printed is cut off."""
        with tempfile.TemporaryFile() as printed:
            child = subprocess.Popen(self.command(argv, limits, **mounts), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                     stderr=subprocess.STDOUT, close_fds=True, start_new_session=True, env={"PATH": "/usr/bin:/bin"})
            status = None
            try:
                end, size = time.monotonic() + limits.wall, 0
                os.set_blocking(child.stdout.fileno(), False)
                while status is None and time.monotonic() < end:
                    status = child.poll()
                    piece = child.stdout.read(1 << 16)
                    if piece:
                        printed.write(piece[:max(0, limits.output - size)])
                        size += len(piece)
                        if size > 64 * limits.output:
                            break  # it prints without end
                    elif status is None:
                        time.sleep(0.004)
                if status is not None:
                    piece = child.stdout.read(limits.output)
                    printed.write((piece or b"")[:max(0, limits.output - size)])
            finally:
                stop(child)
                self.end_all()
            printed.seek(0)
            return Outcome(status, printed.read())


def _free_user() -> tuple[int, socket.socket]:
    """A user that no other slot has, of this grader or of another on this machine. Taken by an abstract socket, which is free again
    when we end, however that is."""
    for user in USERS:
        lease = socket.socket(socket.AF_UNIX)
        try:
            lease.bind(f"\0lantern-grade-user-{user}")
            return user, lease
        except OSError:
            lease.close()
    raise Problem("all users for sandboxes are taken: are other graders running?")


def _is_of(process: pathlib.Path, user: int) -> bool:
    try:
        return process.stat().st_uid == user and "\nState:\tZ" not in (process / "status").read_text()
    except OSError:
        return False


def stop(child: subprocess.Popen) -> None:
    try:
        os.killpg(child.pid, signal.SIGKILL)
    except (ProcessLookupError, PermissionError):
        pass
    child.kill()
    child.wait()
    if child.stdout:
        child.stdout.close()


def translated(word: str, names: dict[str, pathlib.Path]) -> str:
    """A path as it is seen where nothing is mounted."""
    for name in sorted(names, key=len, reverse=True):
        if name in word:
            return word.replace(name, str(names[name]), 1)
    return word


@functools.cache
def bubblewrap() -> str:
    return shutil.which("bwrap") or ""


@functools.cache
def knows_disable_userns() -> bool:
    help_text = subprocess.run([bubblewrap(), "--help"], capture_output=True, text=True, check=False)
    return "--disable-userns" in help_text.stdout + help_text.stderr


@functools.cache
def system_mounts(whole: bool) -> list[str]:
    """Read-only: the system, or no more of it than a program needs to start. Never this checkout, wherever it stands."""
    words: list[str] = []
    for name in ["usr"] if whole else [f"usr/{folder}" for folder in ("lib", "lib32", "lib64", "libx32")]:
        words += ["--ro-bind-try", f"/{name}", f"/{name}"]
    for name in ("bin", "sbin", "lib", "lib32", "lib64", "libx32"):
        path = pathlib.Path("/") / name
        if not whole and "bin" in name:
            continue
        if path.is_symlink():
            words += ["--symlink", os.readlink(path), str(path)]
        elif path.is_dir():
            words += ["--ro-bind", str(path), str(path)]
    for file in ("/etc/ld.so.cache", "/etc/alternatives"):
        words += ["--ro-bind-try", file, file]
    if ROOT.is_relative_to("/usr"):
        words += ["--tmpfs", str(ROOT)]
    return words


# ---- Which way works, and what it holds ----------------------------------------------------------------------------

WAYS = ["bwrap", "bwrap-by-root", "limits"]


@functools.cache
def best_way() -> str:
    """The strictest way that starts a program here."""
    for way in WAYS[:-1]:
        if bubblewrap() and os.path.exists("/usr/bin/prlimit") and os.path.exists("/usr/bin/setpriv") and (way == "bwrap" or is_root()):
            with Sandbox(way) as box:
                if box.run(["/usr/bin/true"], Limits(wall=10), system=True).status == 0:
                    return way
    return WAYS[-1]


def why_not() -> str:
    """Why there is no isolation here."""
    if best_way() != "limits":
        return ""
    if not bubblewrap():
        return "bubblewrap (bwrap) is not installed"
    if not (os.path.exists("/usr/bin/prlimit") and os.path.exists("/usr/bin/setpriv")):
        return "prlimit and setpriv (util-linux) are not installed"
    with Sandbox("bwrap") as box:
        said = box.run(["/usr/bin/true"], Limits(wall=10), system=True).printed.decode(errors="replace").strip()
    return "bubblewrap may not make namespaces here" + (f": {said.splitlines()[0][:200]}" if said else "")


def level(probe: pathlib.Path, secrets: list[pathlib.Path], way: str | None = None) -> Level:
    """Runs the probe where workers run, and reports what it could and could not do. `secrets` must be out of its reach."""
    with tempfile.TemporaryDirectory(prefix="lantern-") as folder, Sandbox(way) as box:
        os.chmod(folder, 0o711)
        program = pathlib.Path(folder) / "probe"
        shutil.copy(probe, program)
        os.chmod(program, 0o755)
        limits = Limits(wall=20)
        outcome = box.run(["/probe", str(limits.processes), str(limits.memory), str(os.getpid()), *map(str, secrets)], limits, readable={"/probe": program})
        try:
            seen = json.loads(outcome.printed)
        except ValueError:
            raise Problem("the sandbox's probe did not run: " + outcome.printed.decode(errors="replace")[:500]) from None
    holds = [name for name, held in seen.items() if held]
    lacks = [name for name, held in seen.items() if not held]
    (holds if box.group.folders else lacks).append("limits over all processes together")
    isolated = box.way != "limits" and not set(lacks) & ESSENTIAL
    return Level(isolated, holds, lacks, why_not() if box.way == "limits" else "")


# What the probe tells, and without which nothing untrusted may run.
ESSENTIAL = {"no network", "tests and solutions out of reach", "nothing to write to", "no environment", "no descriptors", "an unprivileged user",
             "other processes out of reach", "a limit of processes", "a limit of memory"}
