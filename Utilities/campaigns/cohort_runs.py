# SPDX-License-Identifier: GPL-3.0-or-later
"""Starts Utilities/cohort/cohort.py on small surfaces, and looks at its processes and at what it leaves behind."""

import json
import math
import os
import shutil
import signal
import subprocess
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
COHORT = os.path.join(ROOT, "Utilities", "cohort", "cohort.py")
BEGINNINGS_OF_RUNS = ("OMPI_", "PMIX_")  # variables by which a rank knows its run


def write_cap(path, rings, sectors):
    """A bowl as an OBJ file."""
    lines = ["v 0 0 0"]
    for i in range(1, rings + 1):
        for j in range(sectors):
            angle, radius = 2 * math.pi * j / sectors, i / rings
            x, y = radius * math.cos(angle), radius * math.sin(angle)
            lines.append(f"v {x:.6f} {y:.6f} {radius * radius:.6f}")
    for j in range(sectors):
        lines.append(f"f 1 {2 + j} {2 + (j + 1) % sectors}")
    for i in range(rings - 1):
        for j in range(sectors):
            a, b = 2 + i * sectors + j, 2 + i * sectors + (j + 1) % sectors
            lines += [f"f {a} {a + sectors} {b + sectors}", f"f {a} {b + sectors} {b}"]
    with open(path, "w", encoding="ascii") as stream:
        stream.write("\n".join(lines) + "\n")


def make_surfaces(folder, number=7):
    """Files of a cohort; the last one is damaged, so that its case fails."""
    os.makedirs(folder, exist_ok=True)
    paths = [os.path.join(folder, f"cap{k}.obj") for k in range(number)]
    for k, path in enumerate(paths):
        write_cap(path, 14 + 3 * k, 36 + 4 * k)
    paths.append(os.path.join(folder, "damaged.stl"))
    with open(paths[-1], "wb") as stream:
        stream.write(bytes(80) + (50).to_bytes(4, "little") + bytes(100))
    return paths


def environment(scratch):
    values = {name: value for name, value in os.environ.items() if not name.startswith(BEGINNINGS_OF_RUNS)}
    package = os.environ.get("PYTHONPATH") or os.path.join(ROOT, "build", "lib", "python3", "dist-packages")
    values.update(PYTHONPATH=os.path.abspath(package), TMPDIR=scratch, PYTHONDONTWRITEBYTECODE="1",
                  OMPI_MCA_rmaps_base_oversubscribe="1")
    if os.geteuid() == 0:
        values.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    return values


def command(ranks, output, files, options=()):
    program = [shutil.which("pvbatch") or "pvbatch"]
    if ranks > 1:
        program = [shutil.which("mpiexec") or "mpiexec", "-n", str(ranks), "--bind-to", "none", *program]
    return [*program, "--symmetric", COHORT, "--output", output, *options, *files]


class Run:
    """One run of a cohort, with its log in a file."""

    def __init__(self, ranks, output, files, scratch, options=(), preexec_fn=None, variables=()):
        self.output = output
        handle, self.log = tempfile.mkstemp(prefix="log", dir=scratch)  # what is left of a killed run has its own
        with open(handle, "w", encoding="utf-8") as stream:
            self._process = subprocess.Popen(
                command(ranks, output, files, options), stdout=stream, stderr=subprocess.STDOUT,
                env={**environment(scratch), **dict(variables)}, start_new_session=True, preexec_fn=preexec_fn,
            )
        self.first = self._process.pid
        self._seen = {self.first}

    def status(self, seconds):
        """The exit status; None if it goes on after these seconds."""
        try:
            return self._process.wait(timeout=seconds)
        except subprocess.TimeoutExpired:
            return None

    def text(self):
        with open(self.log, encoding="utf-8", errors="replace") as stream:
            return stream.read()

    def processes(self):
        """Processes of the run that live, by depth below the first: [[first], [ranks or children], ...]."""
        parents = {pid: stat[1] for pid, stat in _all_processes().items() if stat[0] != "Z"}
        levels = [[self.first] if self.first in parents else []]
        while levels[-1]:
            levels.append([pid for pid, parent in parents.items() if parent in levels[-1]])
        self._seen.update(pid for level in levels for pid in level)
        return levels[:-1]

    def kill(self, pids):
        for pid in pids:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def survivors(self, seconds):
        """Kills what is left of the run after these seconds; returns how many processes that were."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline and self._living():
            time.sleep(0.05)
        left = self._living()
        self.kill(left)
        self.status(10)
        return len(left)

    def _living(self):
        """All processes of the run's session: also those whose parent is gone."""
        first = self.first
        return [pid for pid, stat in _all_processes().items() if stat[0] != "Z" and (stat[2] == first or pid in self._seen)]


def _all_processes():
    """State, parent and session of each process."""
    found = {}
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{name}/stat", encoding="utf-8") as stream:
                state, parent, _group, session, *_rest = stream.read().rpartition(")")[2].split()
        except (OSError, ValueError):
            continue
        found[int(name)] = (state, int(parent), int(session))
    return found


def content(path):
    with open(path, "rb") as stream:
        return stream.read()


def results(output):
    folder = os.path.join(output, "results")
    return {name: content(os.path.join(folder, name)) for name in sorted(os.listdir(folder))}


def litter(output):
    """Files that a run which came to its end should not leave."""
    names = [name for folder in ("results", "cases") for name in os.listdir(os.path.join(output, folder))]
    return [name for name in names + os.listdir(output) if name.endswith((".part", ".started", ".interrupted"))]


def finished(output):
    """The cases that have a row and a result, with what tells whether they were written again."""
    found = {}
    folder = os.path.join(output, "cases")
    for name in os.listdir(folder) if os.path.isdir(folder) else ():
        if not name.endswith(".json"):
            continue
        try:
            row = json.loads(content(os.path.join(folder, name)))
            paths = [os.path.join(folder, name), os.path.join(output, "results", row["case"] + ".vtp")]
            if row["status"] == "finished":
                states = [os.stat(path) for path in paths]
                found[row["case"]] = [(state.st_ino, state.st_mtime_ns, state.st_size) for state in states]
        except OSError:
            continue
    return found
