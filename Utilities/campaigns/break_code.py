# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks Core in one place after another and runs its tests, which must notice:

    python3 Utilities/campaigns/break_code.py --work ../broken-code --minutes 60

The places are in code_breaks.py. They are all compiled in at once, into a copy of the repository in the folder --work,
as choices that an environment variable makes at run time ("mutant schemata", Untch, Offutt, Harrold 1993, "Mutation
analysis using mutant schemata"), so that nothing is built for each place. A break is killed if a test fails, crashes or
takes ten times as long as without it. The tests of the same folder of Core come first, then the others, the quickest
first; with --folders Transport Untangling only the places and the tests of these folders are taken. Outcomes are kept in
breaks.csv in the folder; a further run takes up those that are left, and starts afresh if Core, its tests or the places
have changed. Exit status: 0 if nothing survived.
"""

import argparse
import csv
import hashlib
import os
import re
import shutil
import subprocess
import sys
import time

from code_breaks import BREAKS

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
CORE = "Filters/Core"
CHOICE = """// The place at which the code is broken; -1: nowhere.
#pragma once
#include <cstdlib>
inline int brokenPlace()
{
  static const int place = std::getenv("BROKEN_PLACE") ? std::atoi(std::getenv("BROKEN_PLACE")) : -1;
  return place;
}
"""
FIELDS = ("place", "file", "line", "original", "broken", "outcome", "test", "seconds")
SLOWDOWN = 10.0  # of a test by which a break is killed, after
GRACE = 20.0  # seconds


def tracked_files():
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], check=True, capture_output=True).stdout
    return [name for name in listed.decode().split("\0") if os.path.isfile(os.path.join(ROOT, name))]


def state(files, places):
    """A fingerprint of what outcomes depend on."""
    digest = hashlib.sha256(repr([BREAKS[place] for place in places]).encode())
    for name in files:
        if name.startswith((CORE, "Testing/Core")):
            with open(os.path.join(ROOT, name), "rb") as stream:
                digest.update(name.encode() + stream.read())
    return digest.hexdigest()


def choice_at(text, place, entry):
    """Where the place begins and ends in the file's text, and the choice that replaces it."""
    if text.count(entry.text) != 1 or entry.text.count(entry.original) != 1:
        sys.exit(f"code_breaks.py: {entry.file}: \"{entry.text}\" does not stand there once; the code has changed")
    if entry.original.endswith(";"):
        choice = f"if (brokenPlace() != {place}) {{ {entry.original} }}"
        assert not entry.broken, "a statement can only be omitted"
    else:
        assert entry.broken, f"{entry.file}: \"{entry.original}\" is no statement and cannot be omitted"
        choice = f"(brokenPlace() == {place} ? ({entry.broken}) : ({entry.original}))"
    start = text.index(entry.text) + entry.text.index(entry.original)
    return start, start + len(entry.original), choice


def read(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


def find_lines():
    lines = []
    for place, entry in enumerate(BREAKS):
        text = read(os.path.join(ROOT, CORE, entry.file))
        lines.append(text[: choice_at(text, place, entry)[0]].count("\n") + 1)
    return lines


def copy(files, source, places):
    """Copies the tracked files, with the choices in them."""
    shutil.rmtree(source, ignore_errors=True)
    for name in files:
        os.makedirs(os.path.dirname(os.path.join(source, name)), exist_ok=True)
        shutil.copy2(os.path.join(ROOT, name), os.path.join(source, name), follow_symlinks=False)
    with open(os.path.join(source, CORE, "Base", "BrokenPlace.h"), "w", encoding="utf-8") as stream:
        stream.write(CHOICE)
    for file in {BREAKS[place].file for place in places}:
        text = read(os.path.join(ROOT, CORE, file))
        choices = [choice_at(text, place, BREAKS[place]) for place in places if BREAKS[place].file == file]
        for start, end, choice in sorted(choices, reverse=True):
            text = text[:start] + choice + text[end:]
        with open(os.path.join(source, CORE, file), "w", encoding="utf-8") as stream:
            stream.write('#include "Base/BrokenPlace.h"\n' + text)


def test_programs(folders):
    """The names of the programs of Core's tests in these folders, with their folders."""
    text = read(os.path.join(ROOT, "Testing", "Core", "CMakeLists.txt"))
    found = re.findall(r"^  (\w+)/(Test\w+)\.cxx$", text, re.MULTILINE)
    return {name: folder for folder, name in found if folder in folders}


def build(source, folder, programs, jobs):
    path = os.path.join(os.path.dirname(source), "build.log")
    print(f"building {len(programs)} test programs; the log is {path}", flush=True)
    with open(path, "w", encoding="utf-8") as log:
        for command in (
            ["cmake", "--preset", "release", "-B", folder, "-DSURFACEFLATTENING_PYTHON=OFF"],
            ["cmake", "--build", folder, "-j", str(jobs), "--target", *programs],
        ):
            if subprocess.run(command, cwd=source, stdout=log, stderr=subprocess.STDOUT, check=False).returncode:
                sys.exit(f"break_code.py: the build failed; see {path}")


def run_test(folder, program, place, limit):
    """Returns whether the program passed, and the seconds that it took."""
    environment = dict(os.environ, BROKEN_PLACE=str(place))
    began = time.monotonic()
    try:
        done = subprocess.run(
            [os.path.join(folder, "Testing", "bin", program), "--gtest_fail_fast", "--gtest_brief=1"],
            env=environment,
            cwd=folder,
            timeout=limit,
            capture_output=True,
            check=False,
        )
        passed = done.returncode == 0
    except subprocess.TimeoutExpired:
        passed = False
    return passed, time.monotonic() - began


def measured_times(folder, programs, path):
    """The seconds that each program takes without a break."""
    if not os.path.exists(path):
        times = {}
        for program in programs:
            passed, times[program] = run_test(folder, program, -1, None)
            if not passed:
                sys.exit(f"break_code.py: {program} fails without a break")
        with open(path, "w", newline="", encoding="utf-8") as stream:
            csv.writer(stream).writerows(times.items())
    with open(path, newline="", encoding="utf-8") as stream:
        return {program: float(seconds) for program, seconds in csv.reader(stream)}


def outcome_of(folder, place, entry, programs, times):
    began = time.monotonic()
    own = entry.file.split("/")[0]
    for program in sorted(programs, key=lambda name: (programs[name] != own, times[name])):
        if not run_test(folder, program, place, SLOWDOWN * times[program] + GRACE)[0]:
            return "killed", program, time.monotonic() - began
    return "survived", "", time.monotonic() - began


def known_outcomes(path):
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def summarise(rows, places):
    survivors = [row for row in rows if row["outcome"] == "survived"]
    print(f"{len(rows)} of {len(places)} places: {len(rows) - len(survivors)} killed, {len(survivors)} survived")
    for row in survivors:
        print(f"  {row['file']}:{row['line']}: {row['original']} -> {row['broken'] or 'omitted'}")
    return survivors


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--work", required=True, help="folder of the copy, its build and the outcomes")
    parser.add_argument("--minutes", type=float, default=1e9, help="ends after so many minutes")
    parser.add_argument("--folders", nargs="+", help="folders of Core, such as Transport; all by default")
    parser.add_argument("--jobs", type=int, default=1, help="parallel compilations")
    arguments = parser.parse_args()
    end = time.monotonic() + 60.0 * arguments.minutes
    work = os.path.abspath(arguments.work)
    source = os.path.join(work, "source")
    folder = os.path.join(source, "build")
    outcomes, times, stamp = (os.path.join(work, name) for name in ("breaks.csv", "times.csv", "state"))
    os.makedirs(work, exist_ok=True)
    files = tracked_files()
    folders = arguments.folders or {entry.file.split("/")[0] for entry in BREAKS}
    places = [place for place, entry in enumerate(BREAKS) if entry.file.split("/")[0] in folders]
    programs = test_programs(folders)
    if not os.path.exists(stamp) or read(stamp) != state(files, places):
        for path in (stamp, outcomes, times):
            if os.path.exists(path):
                os.remove(path)
        copy(files, source, places)
        build(source, folder, programs, arguments.jobs)
        with open(stamp, "w", encoding="utf-8") as stream:
            stream.write(state(files, places))
    seconds = measured_times(folder, programs, times)
    rows = known_outcomes(outcomes)
    lines = find_lines()
    done = {int(row["place"]) for row in rows}
    for place in places:
        entry = BREAKS[place]
        if place in done or time.monotonic() > end:
            continue
        outcome, test, took = outcome_of(folder, place, entry, programs, seconds)
        row = dict(
            zip(FIELDS, (place, entry.file, lines[place], entry.original, entry.broken, outcome, test, f"{took:.1f}"))
        )
        rows.append(row)
        with open(outcomes, "a", newline="", encoding="utf-8") as stream:
            writer = csv.DictWriter(stream, FIELDS)
            if stream.tell() == 0:
                writer.writeheader()
            writer.writerow(row)
        print(f"{place:3} {outcome:8} {entry.file}:{lines[place]} {test}", flush=True)
    sys.exit(1 if summarise(rows, places) or len(rows) < len(places) else 0)


if __name__ == "__main__":
    main()
