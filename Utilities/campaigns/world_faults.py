# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a small cohort in a world that fails, and checks that it says so in a sentence and goes on where it can:

    PYTHONPATH=build/lib/python3/dist-packages python3 Utilities/campaigns/world_faults.py

A disk that is full at several moments or slow, a folder that is read-only or is none, two runs in one folder, a rank
that dies, and too little memory at each stage. After each of them the same command in a sound world must come to the
results of a run that nobody disturbed. The checks of a full disk and of a read-only folder need the right to mount and
are left out without it; that of a slow disk needs a C compiler. Needs Linux. The exit status is 0 if all checks hold.
"""

import os
import re
import signal
import subprocess
import sys
import tempfile
import time

from cohort_runs import Run, content, finished, litter, make_surfaces, results

LONGEST = 120.0  # seconds that a run may take

# Loaded before the C library, it lets each write to a file take a third of a second, and write 4 kB at most.
SLOW_WRITES = """
#define _GNU_SOURCE
#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>
ssize_t write(int file, const void* bytes, size_t count)
{
  static ssize_t (*original)(int, const void*, size_t);
  struct stat status;
  if (!original)
    original = (ssize_t (*)(int, const void*, size_t))dlsym(RTLD_NEXT, "write");
  if (fstat(file, &status) == 0 && S_ISREG(status.st_mode))
  {
    usleep(333000);
    count = count < 4096 ? count : 4096;
  }
  return original(file, bytes, count);
}
"""


class World:
    def __init__(self, scratch):
        self.scratch = scratch
        self.files = make_surfaces(os.path.join(scratch, "surfaces"), number=4)
        self.output = os.path.join(scratch, "undisturbed")
        assert self.run(1).status(LONGEST) == 1  # one file is damaged
        self.expected = (content(os.path.join(self.output, "summary.csv")), results(self.output))
        self.faults = 0

    def run(self, ranks, **options):
        return Run(ranks, self.output, self.files, self.scratch, **options)

    def folder(self, name):
        """A new output folder for the runs that follow."""
        self.output = os.path.join(self.scratch, name)
        return self.output

    def check(self, name, run, statuses, sentence):
        """Waits for the run and looks at its exit status and for a sentence in its log."""
        status = run.status(LONGEST)
        run.survivors(0 if status is None else 10)
        text = run.text()
        found = re.search(sentence, text)
        right = status in statuses and found and "Traceback" not in text
        self.report(name, right, found.group(0) if found else f"status {status}\n{text}")

    def check_sound(self, name):
        """Runs again, now undisturbed, and compares."""
        before = finished(self.output)
        run = self.run(2)
        status = run.status(LONGEST)
        summary, flat = self.expected
        right = status == 1 and content(os.path.join(self.output, "summary.csv")) == summary
        right = right and results(self.output) == flat and not litter(self.output)
        right = right and all(finished(self.output).get(case) == state for case, state in before.items())
        self.report(f"{name}: the run after it", right, f"{len(before)} were finished" if right else run.text())

    def report(self, name, right, text):
        self.faults += not right
        print(f"{'right' if right else 'FAULT'}: {name}: {text}", flush=True)


def check_disk(world):
    """A small disk in memory that is full from the beginning, or becomes so."""
    for free in (0, 16, 100, 300):  # kB
        name = f"a disk with {free} kB of room"
        folder = world.folder(f"disk{free}")
        os.mkdir(folder)
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=600k", "none", folder], check=False).returncode:
            print(f"left out: {name}")
            continue
        try:
            with open(os.path.join(folder, "filler"), "wb") as stream:
                stream.write(bytes((600 - free) * 1000 // 4096 * 4096))
            world.check(name, world.run(2), (2,), r"error: cannot .*(No space left on device|the disk may be full)")
            os.remove(os.path.join(folder, "filler"))
            subprocess.run(["mount", "-o", "remount,size=64m", folder], check=True)
            world.check_sound(name)
        finally:
            subprocess.run(["umount", folder], check=True)


def check_slow_disk(world):
    """A disk on which a result takes seconds; a run is killed while it writes one."""
    library = os.path.join(world.scratch, "slow.so")
    if subprocess.run(["cc", "-shared", "-fPIC", "-x", "c", "-", "-o", library], input=SLOW_WRITES, text=True,
                      check=False).returncode:
        print("left out: a slow disk")
        return
    name = "a slow disk"
    world.folder("slow")
    began = time.monotonic()
    world.check(name, world.run(2, variables={"LD_PRELOAD": library}), (1,), r"4 finished, 1 failed")
    print(f"    {time.monotonic() - began:.1f} s")
    world.check_sound(name)

    name = "a run that is killed while it writes"
    world.folder("killed")
    run = world.run(2, variables={"LD_PRELOAD": library})
    while run.status(0.01) is None and not partial_results(world.output):
        pass
    time.sleep(0.5)
    left = partial_results(world.output)
    run.kill([pid for level in run.processes() for pid in level])
    run.survivors(0)
    world.report(name, bool(left), f"at {', '.join(left)}")
    world.check_sound(name)


def partial_results(output):
    folder = os.path.join(output, "results")
    return [entry for entry in os.listdir(folder) if entry.endswith(".part")] if os.path.isdir(folder) else []


def check_folders(world):
    name = "a folder below a file"
    path = world.folder("file")
    with open(path, "w", encoding="utf-8"):
        pass
    for ranks in (1, 2):
        world.check(name, world.run(ranks), (2,), r"error: cannot make the folder .*: Not a directory")
    name = "a read-only folder"
    folder = world.folder("readonly")
    world.check_sound("no fault")
    if subprocess.run(["mount", "--bind", folder, folder], check=False).returncode:
        print(f"left out: {name}")
        return
    try:
        subprocess.run(["mount", "-o", "remount,ro,bind", folder], check=True)
        for ranks in (1, 2):
            world.check(name, world.run(ranks), (2,), r"error: cannot .*: Read-only file system")
    finally:
        subprocess.run(["umount", folder], check=True)
    world.check_sound(name)


def check_arguments(world):
    world.folder("arguments")
    os.makedirs(os.path.join(world.scratch, "other"), exist_ok=True)
    files, world.files = world.files, [world.files[0], world.files[0].replace(".obj", ".ply")]
    world.check("two files of one name", world.run(2), (2,), r"error: two files would both be the case cap0.*")
    world.files = ["--list", os.path.join(world.scratch, "none")]
    world.check("a list that is not there", world.run(1), (2,), r"error: cannot read .*: No such file or directory")
    world.files = files


def check_two_runs(world):
    world.folder("two")
    first = world.run(1)
    while first.status(0.01) is None and not finished(world.output):
        pass
    os.kill(first.first, signal.SIGSTOP)
    world.check("two runs in one folder", world.run(2), (2,), r"error: another run is at work in the folder .*")
    os.kill(first.first, signal.SIGCONT)
    world.check("the first of them", first, (1,), r"4 finished, 1 failed")
    world.check_sound("two runs in one folder")


def check_rank(world):
    world.folder("rank")
    run = world.run(2)
    while run.status(0.01) is None and not finished(world.output):
        pass
    levels = run.processes()
    run.kill(levels[1][-1:])
    began = time.monotonic()
    world.check("a rank that dies", run, set(range(1, 256)), r"exited on signal 9.*")
    world.report("the end after it", time.monotonic() - began < 20, f"{time.monotonic() - began:.1f} s")
    world.check_sound("a rank that dies")


def check_memory(world):
    """Less and less address space for a case, so that each stage runs out of it in turn."""
    sentences = set()
    name = "little memory"
    world.folder("memory")
    for megabytes in (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 32, 64, 128, 256):
        run = world.run(1, options=["--case-memory", str(megabytes)])
        status = run.status(LONGEST)
        text = run.text()
        sentences.update(re.findall(r"failed: cap\d: (.*)", text))
        right = status == 1 and re.search(r"\d finished, \d failed", text) and "Traceback" not in text
        world.report(f"{name}: {megabytes} MB per case", right, re.findall(r"\d finished, .* failed", text) if right else text)
    for sentence in sorted(sentences):
        print(f"    {sentence}")
    world.check_sound(name)


CHECKS = {
    "disk": check_disk,
    "slow": check_slow_disk,
    "folders": check_folders,
    "arguments": check_arguments,
    "two": check_two_runs,
    "rank": check_rank,
    "memory": check_memory,
}


def main():
    names = sys.argv[1:] or list(CHECKS)
    with tempfile.TemporaryDirectory() as scratch:
        world = World(scratch)
        for name in names:
            CHECKS[name](world)
    print(f"{world.faults} faults")
    return 1 if world.faults else 0


if __name__ == "__main__":
    sys.exit(main())
