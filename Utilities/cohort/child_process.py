# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a function in a child process, so that a crash ends that process alone and the caller learns of it."""

import ctypes
import json
import os
import resource
import select
import signal
import sys
import time
from dataclasses import dataclass

PR_SET_PDEATHSIG = 1  # of Linux's prctl
# MPI and ParaView print a page about these, which the parent reports in a sentence.
REPORTED = (signal.SIGSEGV, signal.SIGABRT, signal.SIGBUS, signal.SIGFPE, signal.SIGILL, signal.SIGTERM)


@dataclass
class Ending:
    """What became of the child: its value, or else the signal that ended it or that its time was up."""

    stage: str = ""  # the last one that it announced
    value: object = None
    signal: int = 0
    status: int = 0
    timed_out: bool = False


def in_child(function, seconds=None, megabytes=None):
    """Calls function(announce) in a child process; returns its Ending.

    The value must be one that JSON can hold. announce(text) tells which stage the child is at. The child ends
    with its parent, whatever ends that.

    @seconds: after which the child is killed; None: never.
    @megabytes: of address space that the child may use beyond those of its parent; None: any.
    """
    readable, writable = os.pipe()
    parent = os.getpid()
    sys.stdout.flush()
    sys.stderr.flush()
    pid = os.fork()
    if pid == 0:
        os.close(readable)
        _be_child(function, writable, parent, megabytes)
    os.close(writable)
    ending = Ending()
    try:
        ending.timed_out = not _listen(readable, ending, seconds)
    finally:
        os.close(readable)
        if ending.timed_out or sys.exc_info()[0]:
            os.kill(pid, signal.SIGKILL)
        _pid, status = os.waitpid(pid, 0)
    if os.WIFSIGNALED(status):
        ending.signal = os.WTERMSIG(status)
    else:
        ending.status = os.WEXITSTATUS(status)
    return ending


def _be_child(function, writable, parent, megabytes):
    """The life of the child; it does not return, and leaves MPI to its parent."""
    status = 1
    try:
        _end_with(parent)
        for number in REPORTED:
            signal.signal(number, signal.SIG_DFL)
        if megabytes:
            limit = _address_space() + int(megabytes * 2**20)
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

        def tell(kind, value):
            text = (json.dumps({kind: value}) + "\n").encode()
            while text:
                text = text[os.write(writable, text) :]

        tell("value", function(lambda stage: tell("stage", stage)))
        status = 0
    except BaseException as error:  # the parent reports a child without a value
        print(f"{type(error).__name__}: {error}", file=sys.stderr)
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)


def _address_space():
    """Bytes of this process."""
    with open("/proc/self/statm", encoding="ascii") as stream:
        return int(stream.read().split()[0]) * resource.getpagesize()


def _end_with(parent):
    """Has the kernel end this process when its parent ends, even by SIGKILL."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
    if os.getppid() != parent:  # it ended before that
        os._exit(1)


def _listen(readable, ending, seconds):
    """Takes what the child tells until it closes its end of the pipe. False: its time was up before."""
    deadline = time.monotonic() + seconds if seconds else None
    text = b""
    while True:
        left = None if deadline is None else max(0.0, deadline - time.monotonic())
        if not select.select([readable], [], [], left)[0]:
            return False
        piece = os.read(readable, 65536)
        if not piece:
            return True
        *lines, text = (text + piece).split(b"\n")
        for line in lines:
            for kind, value in json.loads(line).items():
                setattr(ending, kind, value)
