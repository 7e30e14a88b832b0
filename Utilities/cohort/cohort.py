# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens many surfaces or volumes, shared out over the ranks of ParaView's own MPI:

    export PYTHONPATH=build/lib/python3/dist-packages
    mpiexec -n 8 --bind-to core pvbatch --symmetric Utilities/cohort/cohort.py --output flat --isovalue 40 scans/*.nii.gz

Each rank takes one case after the other, the largest first. A case that fails is listed with its reason, and the others go on. A
run that was killed is started again with the same command: finished cases are not done again. docs/cohort.md has the
files that come out and what a large cohort costs.

The exit status is 0 if all cases are finished, 1 if some failed.
"""

import argparse
import json
import sys
import time

from case_files import CaseError
from case_list import in_order, named_cases
from case_pipeline import CUTS, HANDLES, flatten
from case_records import CaseRecords
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController


class Ranks:
    """The processes of this run: one, or those that mpiexec started."""

    def __init__(self):
        self.controller = vtkMultiProcessController.GetGlobalController()
        self.count = self.controller.GetNumberOfProcesses() if self.controller else 1
        self.own = self.controller.GetLocalProcessId() if self.controller else 0

    def from_first(self, value):
        """Sends the value of the first rank to all."""
        if self.count == 1:
            return value
        text = vtkUnsignedCharArray()
        if self.own == 0:
            for byte in json.dumps(value).encode():
                text.InsertNextValue(byte)
        self.controller.Broadcast(text, 0)
        return json.loads(bytes(text.GetValue(i) for i in range(text.GetNumberOfValues())))

    def wait(self):
        if self.count > 1:
            self.controller.Barrier()

    def line(self, text):
        print(f"[rank {self.own}] {text}", flush=True)


def parsed_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("files", nargs="*", help="surfaces (.vtk .vtp .ply .stl .obj) or volumes "
                        "(.nii .nii.gz .mha .mhd .nrrd .nhdr .vti)")
    parser.add_argument("--list", help="a text file with one file name per line, beside those given")
    parser.add_argument("--output", required=True, help="folder that all ranks see")
    parser.add_argument("--isovalue", type=float, help="of the surface in a volume")
    parser.add_argument("--smoothing", type=float, default=1.0, help="of a volume, mm; 0: none (default 1)")
    parser.add_argument("--cut", choices=CUTS, default="hole", help="how a closed surface is opened")
    parser.add_argument("--plane-normal", type=float, nargs=3, default=[1.0, 0.0, 0.0], metavar=("X", "Y", "Z"),
                        help="with --cut plane: towards the part that is kept (default 1 0 0)")
    parser.add_argument("--plane-origin", type=float, nargs=3, metavar=("X", "Y", "Z"),
                        help="with --cut plane (default: the centre of each surface's bounding box)")
    parser.add_argument("--hole-area", type=float, default=1e-3, help="share of the area (default 0.001)")
    parser.add_argument("--handles", choices=HANDLES, default="remove")
    parser.add_argument("--remesh", action="store_true", help="even triangles: fewer, better shaped, faster")
    parser.add_argument("--edge-length", type=float, default=0.0, help="with --remesh; 0: automatic")
    arguments = parser.parse_args()
    if arguments.list:
        with open(arguments.list, encoding="utf-8") as lines:
            arguments.files += [line.strip() for line in lines if line.strip()]
    if not arguments.files:
        parser.error("no files are given")
    return arguments


def settings_of(arguments):
    names = ("isovalue", "smoothing", "cut", "plane_normal", "plane_origin", "hole_area", "handles", "remesh",
             "edge_length")
    return {name: getattr(arguments, name) for name in names}


def do_case(case, records, settings):
    """Flattens one case and records what came of it; returns that as a text."""
    began = time.monotonic()
    try:
        result = flatten(case.path, settings)
        records.finish(case, result)
    except Exception as error:  # whatever it is, the other cases go on
        reason = str(error) if isinstance(error, CaseError) else f"{type(error).__name__}: {error}"
        records.fail(case, reason)
        return f"failed: {reason}"
    share = result.figures["FacesWithin2Percent"]
    text = f"{time.monotonic() - began:.1f} s, {result.figures['Faces']:,} faces, {share:.1f} % within 2 %"
    return text + (f"; {len(result.warnings)} warnings" if result.warnings else "")


def main():
    began = time.monotonic()
    arguments = parsed_arguments()
    settings = settings_of(arguments)
    ranks = Ranks()
    cases = named_cases(arguments.files)
    records = CaseRecords(arguments.output, settings)
    names = None
    if ranks.own == 0:
        open_cases = [case for case in cases if not records.is_finished(case)]
        interrupted = [case.name for case in open_cases if records.was_started(case)]
        for case in open_cases:
            records.release(case)
        names = [case.name for case in in_order(open_cases, last=interrupted)]
        ranks.line(f"{len(cases)} cases, {len(cases) - len(names)} finished before, {ranks.count} ranks")
    by_name = {case.name: case for case in cases}
    queue = [by_name[name] for name in ranks.from_first(names)]
    for case in queue:
        if records.take(case):
            text = do_case(case, records, settings)
            ranks.line(f"{records.count(queue)}/{len(queue)} {case.name}: {text}")
    ranks.line(f"{time.process_time():.1f} s of processor time, {time.monotonic() - began:.1f} s in all")
    ranks.wait()
    failed = 0
    if ranks.own == 0:
        path, rows = records.write_summary(cases)
        failed = len(rows)
        ranks.line(f"{len(cases) - failed} finished, {failed} failed: {path}")
        for row in rows:
            ranks.line(f"failed: {row['case']}: {row['reason']}")
    failed = ranks.from_first(failed)
    ranks.wait()  # mpiexec ends the others when one ends with a status that is not 0
    if failed:
        sys.exit(1)  # with 0 too pvbatch would leave MPI without a word, which mpiexec takes for a failure


if __name__ == "__main__":
    main()
