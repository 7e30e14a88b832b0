# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps two runs from working in one output folder, also what is left of a killed one for a moment."""

import errno
import fcntl
import os
import time

from case_records import RunError, reported

PATIENCE = 10.0  # seconds in which the other ranks of a killed run end
TAKEN = (errno.EACCES, errno.EAGAIN)


class RunLock:
    """A lock that the kernel releases when all processes that hold it have ended, whatever ended them.

    A file system without locks counts as one where nobody holds it.
    """

    def __init__(self, output):
        self.output = output
        self._stream = None

    def take_alone(self):
        """For the first rank, before it looks at what is there. Raises RunError if another run goes on."""
        deadline = time.monotonic() + PATIENCE
        while not self._take(fcntl.LOCK_EX):
            if time.monotonic() > deadline:
                raise RunError(f"another run is at work in the folder {self.output}")
            time.sleep(0.05)

    def share(self):
        """For every rank, while it takes cases."""
        if not self._take(fcntl.LOCK_SH):
            raise RunError(f"another run has begun in the folder {self.output}")

    def _take(self, kind):
        if self._stream is None:
            path = os.path.join(self.output, "cases", ".lock")
            with reported("write", path):
                self._stream = open(path, "a", encoding="utf-8")
        try:
            fcntl.flock(self._stream, kind | fcntl.LOCK_NB)
        except OSError as error:
            return error.errno not in TAKEN
        return True
