# SPDX-License-Identifier: GPL-3.0-or-later
"""The processes of a run: one, or those that mpiexec started."""

import json
import sys

from shown_text import printable
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController


class Ranks:
    def __init__(self):
        self.controller = vtkMultiProcessController.GetGlobalController()
        self.count = self.controller.GetNumberOfProcesses() if self.controller else 1
        self.own = self.controller.GetLocalProcessId() if self.controller else 0

    def from_one(self, value, rank=0):
        """Sends the value of one rank to all."""
        if self.count == 1:
            return value
        text = vtkUnsignedCharArray()
        if self.own == rank:
            for byte in json.dumps(value).encode():
                text.InsertNextValue(byte)
        self.controller.Broadcast(text, rank)
        return json.loads(bytes(text.GetValue(i) for i in range(text.GetNumberOfValues())))

    def from_all(self, value):
        """The values of all ranks, on each of them."""
        return [self.from_one(value, rank) for rank in range(self.count)]

    def wait(self):
        if self.count > 1:
            self.controller.Barrier()

    def line(self, text):
        # In one write with its end: print() writes the end of the line on its own in pvbatch, so that a line of
        # another rank could come between.
        sys.stdout.write(printable(f"[rank {self.own}] {text}") + "\n")
        sys.stdout.flush()
