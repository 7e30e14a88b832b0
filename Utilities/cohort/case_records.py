# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that a cohort leaves on disk, so that a killed run can be continued.

    <output>/results/<case>.vtp     the flat map
    <output>/cases/<case>.json      its row of the summary
    <output>/cases/<case>.started   while it is at work, by which process; stays behind if that was killed
    <output>/summary.csv            all rows, once all cases are through

A file gets its name once it is complete; until then it has another. The row is written after the result: a
case is finished if it has both, made of the same file with the same settings.
"""

import csv
import json
import os
import socket

from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

FINISHED = "finished"
FAILED = "failed"


class CaseRecords:
    def __init__(self, output, settings):
        self.output = output
        self.settings = settings
        for folder in ("results", "cases"):
            os.makedirs(os.path.join(output, folder), exist_ok=True)

    def result_path(self, case):
        return os.path.join(self.output, "results", case.name + ".vtp")

    def _path(self, case, kind):
        return os.path.join(self.output, "cases", f"{case.name}.{kind}")

    def row(self, case):
        """The row of a case made of this file with these settings; None if there is none."""
        try:
            with open(self._path(case, "json"), encoding="utf-8") as stream:
                row = json.load(stream)
        except (OSError, ValueError):
            return None
        same = row["identity"] == case.identity() and row["settings"] == self.settings
        return row if same else None

    def is_finished(self, case):
        row = self.row(case)
        return bool(row) and row["status"] == FINISHED and os.path.isfile(self.result_path(case))

    def was_started(self, case):
        """Tells whether a process ended while it worked on the case."""
        return os.path.exists(self._path(case, "started"))

    def release(self, case):
        """Makes an unfinished case one that a rank may take."""
        for path in (self._path(case, "started"), self._path(case, "json"), self.result_path(case)):
            if os.path.exists(path):
                os.remove(path)

    def take(self, case):
        """True for one process alone: the first that asks for a released case."""
        if os.path.exists(self._path(case, "json")):
            return False
        try:
            stream = open(self._path(case, "started"), "x", encoding="utf-8")
        except FileExistsError:
            return False
        with stream:
            stream.write(f"{socket.gethostname()} {os.getpid()}\n")
        if os.path.exists(self._path(case, "json")):  # another rank ended it in between
            os.remove(self._path(case, "started"))
            return False
        return True

    def count(self, cases):
        """The number of cases that are finished or have failed."""
        return sum(os.path.exists(self._path(case, "json")) for case in cases)

    def finish(self, case, result):
        path = self.result_path(case)
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(result.flat)
        writer.SetDataModeToBinary()  # Debian's ParaView cannot read appended data
        writer.SetFileName(path + ".part")
        if not writer.Write():
            os.remove(path + ".part")
            raise OSError(f"cannot write {path}: the disk may be full")
        os.replace(path + ".part", path)
        self._end(case, FINISHED, "", result.figures, result.warnings)

    def fail(self, case, reason):
        self._end(case, FAILED, reason, {}, [])

    def _end(self, case, status, reason, figures, warnings):
        row = {
            "case": case.name,
            "status": status,
            "reason": reason,
            "warnings": "; ".join(warnings),
            "figures": figures,
            "settings": self.settings,
            "identity": case.identity(),
        }
        path = self._path(case, "json")
        with open(path + ".part", "w", encoding="utf-8") as stream:
            json.dump(row, stream, indent=1)
        os.replace(path + ".part", path)  # before the mark goes, so that no other rank takes the case
        os.remove(self._path(case, "started"))

    def write_summary(self, cases):
        """Gathers the rows of all cases; returns the path, and the rows of those that failed."""
        rows = [self.row(case) for case in cases]
        missing = [case.name for case, row in zip(cases, rows) if row is None]
        if missing:
            raise RuntimeError(
                f"{len(missing)} cases have no row, {missing[0]} is one: do all ranks see the folder "
                f"{self.output}?"
            )
        columns = list(dict.fromkeys(name for row in rows for name in row["figures"]))
        path = os.path.join(self.output, "summary.csv")
        with open(path + ".part", "w", newline="", encoding="utf-8") as stream:
            writer = csv.writer(stream)
            writer.writerow(["Case", "Status", "Reason", *columns, "Warnings"])
            for row in rows:
                values = [row["figures"].get(name) for name in columns]
                writer.writerow(
                    [row["case"], row["status"], row["reason"]]
                    + ["" if value is None else value for value in values]
                    + [row["warnings"]]
                )
        os.replace(path + ".part", path)
        return path, [row for row in rows if row["status"] == FAILED]
