# SPDX-License-Identifier: GPL-3.0-or-later
"""Damages small valid files at random and takes each through the cohort's readers and filters, in a process of its own:

    PYTHONPATH=build/lib/python3/dist-packages pvpython Utilities/campaigns/mutated_files.py --files 5000 --seed 1

Prints a table with a row per format, also if it is interrupted with Ctrl-C:
    read         files that became a flat map, as a whole
    warned       the same with a warning of the reading
    refused      with a message of the reading or of a filter
    VTK crashed  crashes of VTK's readers or image filters, contained in the process
    VTK silent   DICOM files cut short that VTK's reader takes without a message; the cohort does not read DICOM
    ours         faults of the project: crashes of its filters, Python errors, figures that are not finite, and files cut
                 short that became a smaller flat map without a warning; an .obj file that ends after a line is whole for
                 all that one can tell
    hangs        of any kind
    worst        the longest time, in seconds
Files with a fault are kept in --keep, with the seed in their name. The exit status is 0 if there are no faults and hangs.
"""

import argparse
import collections
import math
import os
import random
import shutil
import signal
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "cohort"))

from case_files import CaseError, Messages
from case_pipeline import CONTOUR, CUTS, HANDLES, READING, flatten, flatten_data
from child_process import in_child
from mutations import mutated
from shown_text import printable
from small_files import ISOVALUE, write_small_files
from vtkmodules.vtkIOImage import vtkDICOMImageReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter

COLUMNS = ("read", "warned", "refused", "VTK crashed", "VTK silent", "ours", "hangs")
OF_VTK = (READING, CONTOUR, "")


def random_settings(chance):
    return {
        "isovalue": ISOVALUE,
        "smoothing": chance.choice((0.0, 1.0)),
        "cut": chance.choice(list(CUTS)),
        "plane_normal": [1.0, 0.0, 0.0],
        "plane_origin": None,
        "hole_area": 1e-3,
        "handles": chance.choice(HANDLES),
        "remesh": chance.random() < 0.2,
        "edge_length": 0.0,
        "free_outline": False,
    }


def flat_map(path, settings, announce):
    """The CaseResult of a file or a folder with a DICOM series. Raises CaseError."""
    if not os.path.isdir(path):
        return flatten(path, settings, announce)
    announce(READING)
    image = path + ".vti"
    ending = in_child(lambda _announce: series_to_image(path, image))
    if ending.value is None:
        os.abort()  # at this stage, which names the reader
    if ending.value:
        raise CaseError(ending.value)
    reader = vtkXMLImageDataReader()
    reader.SetFileName(image)
    reader.Update()
    return flatten_data(reader.GetOutput(), True, settings, announce, [])


def series_to_image(folder, image):
    """Reads a DICOM series into an image file; returns VTK's message, empty if there is none. VTK's reader writes beyond
    its memory where slices differ in size, which would break whatever comes after it in this process."""
    reader = vtkDICOMImageReader()
    with Messages() as messages:
        reader.SetDirectoryName(folder)
        reader.Update()
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(image)
    writer.SetInputData(reader.GetOutput())
    writer.Write()
    return "".join((messages.errors + messages.warnings)[:1])


def not_finite(figures):
    """The first figure that is not finite, as a text; empty if all are."""
    for name, figure in figures.items():
        if figure is not None and not math.isfinite(figure):
            return f"{name} is {figure}"
    return ""


def is_whole_obj(path):
    """Tells whether the file is of the format that does not say how long it is, and ends after a line."""
    if not path.endswith(".obj"):
        return False
    with open(path, "rb") as stream:
        return stream.read().endswith(b"\n")


def outcome(path, settings, log):
    """A function for in_child()."""

    def work(announce):
        os.dup2(os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), 2)
        try:
            result = flat_map(path, settings, announce)
        except CaseError as error:
            return {"refused": str(error)}
        except Exception as error:  # a fault
            return {"fault": f"{type(error).__name__}: {error}"}
        return {"figures": result.figures, "warnings": result.warnings}

    return work


class Campaign:
    def __init__(self, scratch, arguments):
        self.scratch = scratch
        self.arguments = arguments
        files = write_small_files(os.path.join(scratch, "valid"))
        self.files = {name: files[name] for name in arguments.formats or files}
        self.table = {name: collections.Counter() for name in self.files}
        self.worst = collections.Counter()

    def run(self):
        for number in range(self.arguments.files):
            name = list(self.files)[number % len(self.files)]
            self.one(name, f"{self.arguments.seed}-{number}")

    def one(self, name, seed):
        """Damages one file. The file and the settings depend on the seed alone."""
        chance = random.Random(seed)
        source = chance.choice(self.files[name])
        settings = random_settings(chance)
        path = os.path.join(self.scratch, f"damaged.{name}")
        kind = self.write_damaged(source, path, chance)
        column, text, seconds = self.judged(source, path, kind, settings)
        self.table[name][column] += 1
        self.worst[name] = max(self.worst[name], seconds)
        slow = seconds > self.arguments.slow
        if column in ("ours", "hangs") or slow or self.arguments.verbose:
            cause = f"{kind} of {os.path.basename(source)}: {text}; {settings}"
            print(printable(f"{column}: {seconds:.1f} s, seed {seed}, {cause}"), flush=True)
        if (slow or column in ("ours", "hangs")) and self.arguments.keep:
            self.keep(path, os.path.join(self.arguments.keep, f"{seed}-{kind}.{name}"))

    def write_damaged(self, source, path, chance):
        if os.path.isdir(source):
            shutil.rmtree(path, ignore_errors=True)
            shutil.copytree(source, path)
            slices = sorted(os.listdir(path))
            source = path = os.path.join(path, chance.choice(slices))
        with open(source, "rb") as stream:
            kind, data = mutated(stream.read(), chance)
        with open(path, "wb") as stream:
            stream.write(data)
        return kind

    def judged(self, source, path, kind, settings):
        """The column, why, and the seconds."""
        log = os.path.join(self.scratch, "log")
        began = time.monotonic()
        ending = in_child(outcome(path, settings, log), self.arguments.seconds, self.arguments.megabytes or None)
        seconds = time.monotonic() - began
        if ending.timed_out:
            return "hangs", f"in {ending.stage}", seconds
        if ending.value is None:
            text = f"signal {ending.signal}, exit status {ending.status} in {ending.stage}"
            return "VTK crashed" if ending.stage in OF_VTK else "ours", text, seconds
        if "refused" in ending.value:
            return "refused", ending.value["refused"], seconds
        fault = ending.value.get("fault") or not_finite(ending.value["figures"])
        if fault:
            return "ours", fault, seconds
        if kind == "cut" and not is_whole_obj(path) and self.is_silently_cut(ending.value, source, settings):
            column = "VTK silent" if os.path.isdir(source) else "ours"
            return column, "the file is cut short, and nothing is said", seconds
        return "warned" if ending.value["warnings"] else "read", "", seconds

    def is_silently_cut(self, value, source, settings):
        """Tells whether a file that was cut short became another flat map than the whole one, without a warning."""
        if value["warnings"]:
            return False
        whole = in_child(outcome(source, settings, os.devnull), self.arguments.seconds).value or {}
        return whole.get("figures") != value["figures"]

    def keep(self, path, place):
        os.makedirs(self.arguments.keep, exist_ok=True)
        if os.path.isdir(path):
            shutil.copytree(path, place, dirs_exist_ok=True)
        else:
            shutil.copy(path, place)

    def report(self):
        """Prints the table; returns the number of faults."""
        print(f"{'format':8}{'files':>8}" + "".join(f"{name:>12}" for name in COLUMNS) + f"{'worst':>8}")
        total = sum(self.table.values(), collections.Counter())
        for name, counts in [*self.table.items(), ("all", total)]:
            worst = max(self.worst.values()) if name == "all" else self.worst[name]
            print(f"{name:8}{sum(counts.values()):8}" + "".join(f"{counts[c]:12}" for c in COLUMNS) + f"{worst:8.1f}")
        return total["ours"] + total["hangs"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--files", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=60.0, help="after which a file hangs (default 60)")
    parser.add_argument("--megabytes", type=float, default=6000.0,
                        help="of address space per file; 0: any, for the address sanitizer (default 6000)")
    parser.add_argument("--formats", nargs="*", help="some of the formats; the files depend on which")
    parser.add_argument("--one", metavar="SEED-NUMBER", help="repeat one file of a run, such as 1-4711")
    parser.add_argument("--keep", help="a folder for the files with a fault")
    parser.add_argument("--verbose", action="store_true", help="print what becomes of each file")
    parser.add_argument("--slow", type=float, default=20.0, help="seconds after which a file is printed too (default 20)")
    arguments = parser.parse_args()
    signal.signal(signal.SIGINT, signal.default_int_handler)  # pvpython's ends the program
    with tempfile.TemporaryDirectory() as scratch:
        campaign = Campaign(scratch, arguments)
        if arguments.one:
            names = list(campaign.files)
            campaign.one(names[int(arguments.one.split("-")[1]) % len(names)], arguments.one)
        else:
            try:
                campaign.run()
            except KeyboardInterrupt:
                print("interrupted")
        sys.exit(1 if campaign.report() else 0)


if __name__ == "__main__":
    main()
