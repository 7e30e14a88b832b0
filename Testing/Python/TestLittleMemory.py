# SPDX-License-Identifier: GPL-3.0-or-later
"""Each filter on the way to a flat map, with less and less memory: an error with an empty output, or the right map, and
the right map as soon as there is memory again. Every run is a child process with a limit on its address space. And an
edge length for which there is too little memory: an error that names it."""

import ctypes
import os
import resource
import signal
import traceback

import surfaceflattening
from vtkmodules.vtkFiltersSources import vtkSphereSource

STAGES = ("vtkSurfaceToDiskFilter", "vtkConformalDiskFilter", "vtkOMTAreaPreservingFilter", "vtkDistortionMetrics")
MEGABYTES = (0.5, 1, 2, 4, 8, 16, 64, 384)
FAILED = 3  # exit status of a child whose filter reported an error; what it prints is mixed with other messages
LONGEST = 60  # processor seconds of a child, some twenty times what it takes


def pipeline():
    source = vtkSphereSource()
    source.SetThetaResolution(150)
    source.SetPhiResolution(150)
    filters = [source]
    for name in STAGES:
        filters.append(getattr(surfaceflattening, name)())
        filters[-1].SetInputConnection(filters[-2].GetOutputPort())
    filters[1].SetCutMode(1)
    return filters


def result(filter):
    filter.Update()
    output = filter.GetOutput()
    return bytes(memoryview(output.GetPoints().GetData())) if output.GetNumberOfPoints() else None


def limit(megabytes):
    """Lets the process have so much more memory; lifts the limit for None."""
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    if megabytes is None:
        resource.setrlimit(resource.RLIMIT_AS, (hard, hard))
        return
    ctypes.CDLL(None).malloc_trim(0)
    with open("/proc/self/statm", encoding="ascii") as stream:
        size = int(stream.read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (size + int(megabytes * 1e6), hard))


def run_in_child(stage, megabytes):
    """The exit status of the child."""
    resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    # Before the limit, because oneTBB 2022 and OpenBLAS try for ever if they find no memory when they are called first.
    expected = result(pipeline()[stage])
    filters = pipeline()
    filters[stage - 1].Update()
    errors = []
    filters[stage].AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
    limit(megabytes)
    little = result(filters[stage])
    limit(None)
    assert little == expected if little else len(errors) == 1, f"{len(errors)} errors, {little and len(little)} bytes"
    filters[stage].Modified()
    assert result(filters[stage]) == expected, "another result once there was memory again"
    return FAILED if errors else 0


def child(stage, megabytes):
    """What became of a child; asserts that it came to an end by itself."""
    reading, writing = os.pipe()
    process = os.fork()
    if process == 0:
        os.dup2(writing, 1)
        os.dup2(writing, 2)
        status = 1
        try:
            status = run_in_child(stage, megabytes)
        except BaseException:  # os._exit would not print it
            traceback.print_exc()
        finally:
            os._exit(status)
    os.close(writing)
    with os.fdopen(reading, encoding="utf-8", errors="replace") as stream:
        text = stream.read()
    status = os.waitpid(process, 0)[1]
    # VTK ends the program where an array finds no memory, unless it was built with NDEBUG; so do the C library where the
    # local data of a thread finds none, and the library of OpenMP, on which CHOLMOD depends, where it finds none itself.
    if os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGABRT and "Unable to allocate" in text:
        return "ended"
    if "cannot allocate memory for thread-local data" in text or "libgomp: Out of memory" in text:
        return "ended"
    code = os.waitstatus_to_exitcode(status)
    assert code in (0, FAILED), f"{STAGES[stage - 1]} with {megabytes} MB: status {code}: {text[-500:]}"
    return "failed" if code == FAILED else "done"


def refused_remeshing():
    """What Surface To Disk says where it has 2 GB for ten million points. No work is begun, so no child is needed."""
    to_disk = pipeline()[1]
    to_disk.RemeshOn()
    to_disk.SetTargetEdgeLength(6e-4)  # the sphere has an area of pi
    errors = []

    def keep(caller, event, message):
        errors.append(message)

    keep.CallDataType = "string0"
    to_disk.AddObserver("ErrorEvent", keep)
    limit(2000)
    assert result(to_disk) is None
    limit(None)
    assert len(errors) == 1, errors
    return errors[0]


if __name__ == "__main__":
    for stage, name in enumerate(STAGES, 1):
        outcomes = [child(stage, megabytes) for megabytes in MEGABYTES]
        print(name, *outcomes, flush=True)
        assert outcomes[-1] == "done" and (name == "vtkDistortionMetrics" or "failed" in outcomes)
    message = refused_remeshing()
    assert "memory" in message and "set a greater length" in message, message
