# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens many surfaces or volumes, shared out over the ranks of ParaView's own MPI:

    export PYTHONPATH=build/lib/python3/dist-packages
    mpiexec -n 8 --bind-to core pvbatch --symmetric Utilities/cohort/cohort.py --output flat --isovalue 40 scans/*.nii.gz

Each rank takes one case after the other, the largest first, and does it in a child process. A case that fails, or whose
process crashes, is listed with its reason, and the others go on. A run that was killed is started again with the same
command: finished cases are not done again. docs/cohort.md has the files that come out and what a large cohort costs.

The exit status is 0 if all cases are finished, 1 if some failed, 2 if the run could not go on.
"""

import argparse
import math
import os
import resource
import sys
import time

from case_list import CaseNameError, in_order, named_cases
from case_pipeline import CUTS, HANDLES
from case_process import flattened
from case_records import CaseRecords, RunError
from ranks import Ranks
from run_lock import RunLock
from surfaceflattening import vtkSurfaceToDiskFilter

MOST = 1e9  # of seconds or megabytes of a limit: 30 years, and more than any machine has


def is_negative(text):
    """Whether an argument is a number with a minus sign."""
    try:
        return text.startswith("-") and math.isfinite(float(text))
    except ValueError:
        return False


def finite(text):
    """The number that an argument is, for argparse."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text.strip()!r} is not allowed: give a finite number")
    return value


def limit(text):
    """The limit of a case that an argument is, for argparse."""
    value = finite(text)
    if not 0 < value <= MOST:
        raise argparse.ArgumentTypeError(
            f"{text.strip()!r} is not allowed: give a number more than 0 and at most {MOST:g}, or leave the option out for no limit"
        )
    return value


def hole_area(text):
    """The share of the area that an argument is, for argparse."""
    value = finite(text)
    disk = vtkSurfaceToDiskFilter()  # which would take the nearest value for one outside its range
    least, most = disk.GetHoleAreaFractionMinValue(), disk.GetHoleAreaFractionMaxValue()
    if not least <= value <= most:
        raise argparse.ArgumentTypeError(f"{text.strip()!r} is not allowed: give a share of the area from {least:g} to {most:g}")
    return value


def listed_files(path):
    """The names in a list of files. Raises OSError, and ValueError if it is no text file."""
    # Names that are not UTF-8 as on the command line; some editors put a mark before the first name (utf-8-sig).
    with open(path, encoding="utf-8-sig", errors="surrogateescape") as lines:
        names = [line.strip() for line in lines if line.strip()]
    if any("\0" in name for name in names):
        raise ValueError("it is not a text file, or one in UTF-16: save it in UTF-8")
    return names


def parsed_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("files", nargs="*", help="surfaces (.vtk .vtp .ply .stl .obj) or volumes "
                        "(.nii .nii.gz .mha .mhd .nrrd .nhdr .vti)")
    parser.add_argument("--list", help="a text file with one file name per line, beside those given")
    parser.add_argument("--output", required=True, help="folder that all ranks see")
    parser.add_argument("--isovalue", type=finite, help="of the surface in a volume")
    parser.add_argument("--smoothing", type=finite, default=1.0, help="of a volume, mm; 0: none (default 1)")
    parser.add_argument("--cut", choices=CUTS, default="automatic",
                        help="how a closed surface is opened (default: automatic)")
    parser.add_argument("--plane-normal", type=finite, nargs=3, default=[1.0, 0.0, 0.0], metavar=("X", "Y", "Z"),
                        help="with --cut plane: towards the part that is kept (default 1 0 0)")
    parser.add_argument("--plane-origin", type=finite, nargs=3, metavar=("X", "Y", "Z"),
                        help="with --cut plane, in mm to the patient's right, front and top for a "
                        "scan with an orientation (default: the centre of each surface's bounding box)")
    parser.add_argument("--hole-area", type=hole_area, default=1e-3,
                        help="with --cut hole: share of the area (default 0.001)")
    parser.add_argument("--handles", choices=HANDLES, default="remove")
    parser.add_argument("--remesh", action="store_true", help="even triangles: fewer, better shaped, faster")
    parser.add_argument("--edge-length", type=finite, default=0.0, help="with --remesh; 0: automatic")
    parser.add_argument("--free-outline", action="store_true", help="a map that is not forced into a disk")
    parser.add_argument("--case-memory", type=limit, metavar="MB", help="of memory that a case may use")
    parser.add_argument("--case-time", type=limit, metavar="S", help="seconds after which a case is given up")
    # Older Pythons take -4e2 for an option, since they know no exponents, but not " -4e2".
    arguments = parser.parse_args([" " + word if is_negative(word) else word for word in sys.argv[1:]])
    if arguments.list:
        try:
            arguments.files += listed_files(arguments.list)
        except (OSError, ValueError) as error:
            parser.error(f"cannot read {arguments.list}: {getattr(error, 'strerror', None) or error}")
    if not arguments.files:
        parser.error("no files are given")
    return arguments


def settings_of(arguments):
    names = ("isovalue", "smoothing", "cut", "plane_normal", "plane_origin", "hole_area", "handles", "remesh",
             "edge_length", "free_outline")
    return {name: getattr(arguments, name) for name in names}


def do_case(case, records, settings, limits):
    """Flattens one case and records what came of it; returns that as a text."""
    began = time.monotonic()
    try:
        outcome = flattened(case, records, settings, limits)
        if "reason" in outcome:
            records.fail(case, outcome["reason"])
            return f"failed: {outcome['reason']}"
        records.finish(case, **outcome)
    except RunError:
        records.drop(case)
        raise
    figures = outcome["figures"]
    share = figures["FacesWithin2Percent"]
    text = f"{time.monotonic() - began:.1f} s, {figures['Faces']:,} faces, {share:.1f} % within 2 %"
    return text + (f"; {len(outcome['warnings'])} warnings" if outcome["warnings"] else "")


def planned(cases, records, lock):
    """The names of the cases that are to be done, in order, after the traces of a killed run are removed."""
    records.make_folders()
    lock.take_alone()
    todo = []
    for case in cases:
        if records.is_finished(case):
            records.tidy(case)
        else:
            records.release(case)
            todo.append(case)
    return [case.name for case in in_order(todo, records.interruptions)]


def begin(files, records, lock, ranks):
    """All cases, and those that are to be done in order. Raises RunError on all ranks if there is no beginning."""
    plan = {}
    if ranks.own == 0:
        try:
            plan["names"] = planned(named_cases(files), records, lock)
            lock.share()
        except (CaseNameError, RunError) as error:
            plan["error"] = str(error)
    plan = ranks.from_one(plan)
    if "error" in plan:
        raise RunError(plan["error"])
    cases = named_cases(files)
    by_name = {case.name: case for case in cases}
    return cases, [by_name[name] for name in plan["names"]]


def work(queue, records, lock, ranks, arguments):
    """Does the cases that no other rank takes. Returns why this rank could not go on, if so."""
    limits = {"seconds": arguments.case_time, "megabytes": arguments.case_memory}
    settings = settings_of(arguments)
    try:
        lock.share()
        for case in queue:
            if records.take(case):
                text = do_case(case, records, settings, limits)
                ranks.line(f"{records.count(queue)}/{len(queue)} {case.name}: {text}")
    except RunError as error:
        return str(error)
    return ""


def summarise(cases, records, ranks):
    """Writes the summary; returns the number of cases that failed."""
    path, failed = records.write_summary(cases)
    ranks.line(f"{len(cases) - len(failed)} finished, {len(failed)} failed: {path}")
    for row in failed:
        ranks.line(f"failed: {row['case']}: {row['reason']}")
    return len(failed)


def processor_seconds():
    usages = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)


def run(arguments, ranks):
    """The exit status. Raises RunError on all ranks."""
    began = time.monotonic()
    records = CaseRecords(arguments.output, settings_of(arguments))
    lock = RunLock(arguments.output)
    cases, queue = begin(arguments.files, records, lock, ranks)
    if ranks.own == 0:
        ranks.line(f"{len(cases)} cases, {len(cases) - len(queue)} finished before, {ranks.count} ranks")
    trouble = work(queue, records, lock, ranks, arguments)
    ranks.line(f"{processor_seconds():.1f} s of processor time, {time.monotonic() - began:.1f} s in all")
    troubles = [text for text in ranks.from_all(trouble) if text]
    if troubles:
        raise RunError(troubles[0])
    end = {}
    if ranks.own == 0:
        try:
            end["failed"] = summarise(cases, records, ranks)
        except RunError as error:
            end["error"] = str(error)
    end = ranks.from_one(end)
    if "error" in end:
        raise RunError(end["error"])
    return 1 if end["failed"] else 0


def main():
    arguments = parsed_arguments()
    ranks = Ranks()
    try:
        status = run(arguments, ranks)
    except RunError as error:
        if ranks.own == 0:
            ranks.line(f"error: {error}")
        status = 2
    ranks.wait()  # mpiexec ends the others when one ends with a status that is not 0
    if status:
        sys.exit(status)  # with 0 too pvbatch would leave MPI without a word, which mpiexec takes for a failure


if __name__ == "__main__":
    main()
