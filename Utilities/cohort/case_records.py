# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that a cohort leaves on disk, so that a killed run can be continued.

    <output>/results/<case>.vtp         the flat map
    <output>/cases/<case>.json          its row of the summary
    <output>/cases/<case>.started       while it is at work, by which process; stays behind if that was killed
    <output>/cases/<case>.interrupted   a line for each time that a process was killed at work on it
    <output>/summary.csv, costs.csv     all rows, once all cases are through

A file gets its name once it is complete; until then it has another. The row is written after the result: a
case is finished if it has both, made of the same file with the same settings.
"""

import contextlib
import csv
import json
import os
import socket

from shown_text import without_controls
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

FINISHED = "finished"
FAILED = "failed"
FOLDERS = ("results", "cases")


class RunError(Exception):
    """Why a run cannot go on, in a sentence for the user."""


@contextlib.contextmanager
def reported(action, path):
    """Turns an error of the system into a RunError."""
    try:
        yield
    except OSError as error:
        raise RunError(f"cannot {action} {path}: {error.strerror or error}") from None


def remove(*paths):
    for path in paths:
        with reported("remove", path), contextlib.suppress(FileNotFoundError):
            os.remove(path)


@contextlib.contextmanager
def without_rest(path):
    """Removes a file, as far as the disk allows it, that could not be written to its end."""
    try:
        yield
    except OSError:
        with contextlib.suppress(OSError):
            os.remove(path)
        raise


@contextlib.contextmanager
def whole_file(path, **options):
    """A stream for a text file that gets its name once it is complete. Raises RunError.

    Names of files that are not UTF-8 become the bytes that they are on disk: read them with the same errors=.
    """
    part = path + ".part"
    with reported("write", path), without_rest(part):
        with open(part, "w", encoding="utf-8", errors="surrogateescape", **options) as stream:
            yield stream
        os.replace(part, path)


class CaseRecords:
    def __init__(self, output, settings):
        self.output = output
        self.settings = settings
        self._identities = {}  # of the cases that this process took, as they were then

    def make_folders(self):
        for name in FOLDERS:
            path = os.path.join(self.output, name)
            with reported("make the folder", path):
                os.makedirs(path, exist_ok=True)

    def result_path(self, case):
        return os.path.join(self.output, "results", case.name + ".vtp")

    def _path(self, case, kind):
        return os.path.join(self.output, "cases", f"{case.name}.{kind}")

    def row(self, case):
        """The row of a case made of this file with these settings; None if there is none."""
        try:
            with open(self._path(case, "json"), encoding="utf-8") as stream:
                row = json.load(stream)
            same = row["identity"] == case.identity() and row["settings"] == self.settings
        except (OSError, ValueError, KeyError, TypeError):
            return None
        return row if same else None

    def is_finished(self, case):
        row = self.row(case)
        if not row or row["status"] != FINISHED or not os.path.isfile(self.result_path(case)):
            return False
        return os.path.getsize(self.result_path(case)) == row.get("result_bytes")

    def interruptions(self, case):
        """How often a process was killed while it worked on the case."""
        try:
            with open(self._path(case, "interrupted"), encoding="utf-8") as stream:
                return len(stream.readlines())
        except OSError:
            return 0

    def tidy(self, case):
        """Removes what a process that was killed may have left of a finished case."""
        remove(*(self._path(case, kind) for kind in ("started", "interrupted")))

    def release(self, case):
        """Makes an unfinished case one that a rank may take."""
        started, interrupted = self._path(case, "started"), self._path(case, "interrupted")
        if os.path.exists(started):
            with reported("write", interrupted), open(interrupted, "a", encoding="utf-8") as stream:
                stream.write("killed\n")
        result, row = self.result_path(case), self._path(case, "json")
        remove(started, row, row + ".part", result, result + ".part")

    def take(self, case):
        """True for one process alone: the first that asks for a released case."""
        if os.path.exists(self._path(case, "json")):
            return False
        started = self._path(case, "started")
        try:
            with reported("write", started), contextlib.suppress(FileExistsError):
                with open(started, "x", encoding="utf-8") as stream:
                    stream.write(f"{socket.gethostname()} {os.getpid()}\n")
                if not os.path.exists(self._path(case, "json")):
                    self._identities[case.name] = case.identity()
                    return True
                os.remove(started)  # another rank ended it in between
        except RunError:
            self.drop(case)
            raise
        return False

    def drop(self, case):
        """Gives a case that was taken back, as far as the disk allows it."""
        with contextlib.suppress(OSError):
            os.remove(self._path(case, "started"))

    def count(self, cases):
        """The number of cases that are finished or have failed."""
        return sum(os.path.exists(self._path(case, "json")) for case in cases)

    def write_result(self, case, flat):
        """Writes the flat map beside its place: finish() puts it there."""
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(flat)
        writer.SetDataModeToBinary()  # Debian's ParaView cannot read appended data
        writer.WriteToOutputStringOn()  # VTK 9.1 crashes if it writes to a full disk
        written = writer.Write() and writer.GetOutputString()
        if not written:
            raise MemoryError
        text = written.encode() if isinstance(written, str) else written
        path = self.result_path(case)
        with reported("write", path), without_rest(path + ".part"), open(path + ".part", "wb") as stream:
            stream.write(text)

    def finish(self, case, figures, costs, warnings):
        path = self.result_path(case)
        with reported("write", path):
            size = os.path.getsize(path + ".part")
            os.replace(path + ".part", path)
        self._end(case, status=FINISHED, reason="", figures=figures, costs=costs, warnings=warnings,
                  result_bytes=size)

    def fail(self, case, reason):
        remove(self.result_path(case) + ".part")
        self._end(case, status=FAILED, reason=reason, figures={}, costs={}, warnings=[])

    def _end(self, case, **row):
        row["reason"] = without_controls(row["reason"])
        row["warnings"] = [without_controls(warning) for warning in row["warnings"]]
        row.update(case=case.name, settings=self.settings, identity=self._identities[case.name])
        path = self._path(case, "json")
        with whole_file(path) as stream:  # before the mark goes, so that no other rank takes the case
            json.dump(row, stream, indent=1)
        self.tidy(case)

    def write_summary(self, cases):
        """Gathers the rows of all cases; returns the path, and the rows of those that failed."""
        rows = [self.row(case) for case in cases]
        missing = [case.name for case, row in zip(cases, rows) if row is None]
        if missing:
            raise RunError(
                f"{len(missing)} cases have no row, {missing[0]} is one: did its file change during the run, or "
                f"do not all ranks see the folder {self.output}?"
            )
        self._write_costs(rows)
        columns = list(dict.fromkeys(name for row in rows for name in row["figures"]))
        path = os.path.join(self.output, "summary.csv")
        with whole_file(path, newline="") as stream:
            writer = csv.writer(stream)
            writer.writerow(["Case", "Status", "Reason", *columns, "Warnings"])
            for row in rows:
                values = [row["figures"].get(name) for name in columns]
                writer.writerow(
                    [row["case"], row["status"], row["reason"]]
                    + ["" if value is None else value for value in values]
                    + ["; ".join(row["warnings"])]
                )
        return path, [row for row in rows if row["status"] == FAILED]

    def _write_costs(self, rows):
        columns = list(dict.fromkeys(name for row in rows for name in row["costs"]))
        with whole_file(os.path.join(self.output, "costs.csv"), newline="") as stream:
            writer = csv.writer(stream)
            writer.writerow(["Case", *columns])
            writer.writerows([row["case"], *(row["costs"].get(name, "") for name in columns)] for row in rows)
