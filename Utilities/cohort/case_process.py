# SPDX-License-Identifier: GPL-3.0-or-later
"""One case in a child process: whatever ends that, there is a sentence for the summary."""

import os
import resource
import signal

from case_files import CaseError
from case_pipeline import READING, flatten
from case_records import RunError
from child_process import in_child

WRITING = "the writer"
READING_SECONDS = 600  # of processor time, of which good files need few: some damaged ones keep a reader busy for ever


def flattened(case, records, settings, limits):
    """Flattens a case and writes its result, still under another name.

    Returns the figures, costs and warnings by these names, or the reason that there are none. Raises RunError if
    the output folder or the machine does not allow it.

    @limits: seconds and megabytes, as of in_child().
    """

    def work(announce):
        stage = ""

        def begin(name):
            nonlocal stage
            stage = name
            announce(name)
            limit_processor_time(READING_SECONDS if name == READING else None)

        try:
            result = flatten(case.path, settings, begin)
            begin(WRITING)
            records.write_result(case, result.flat)
        except CaseError as error:
            return {"reason": str(error)}
        except RunError as error:
            return {"trouble": str(error)}
        except MemoryError:
            return {"reason": f"there was not enough memory for {stage}"}
        except Exception as error:  # whatever it is, the other cases go on
            return {"reason": f"{type(error).__name__}: {error}"}
        return {"figures": result.figures, "costs": result.costs, "warnings": result.warnings}

    try:
        ending = in_child(work, **limits)
    except OSError as error:
        raise RunError(f"cannot start a process for a case: {os.strerror(error.errno)}") from None
    outcome = ending.value or {"reason": reason(ending, **limits)}
    if "trouble" in outcome:
        raise RunError(outcome["trouble"])
    return outcome


def limit_processor_time(seconds):
    """Has the kernel end this process by SIGXCPU when it has used so many seconds from now on; None: never."""
    _soft, hard = resource.getrlimit(resource.RLIMIT_CPU)
    limit = hard
    if seconds is not None:
        usage = resource.getrusage(resource.RUSAGE_SELF)
        limit = int(usage.ru_utime + usage.ru_stime + seconds) + 1
        limit = limit if hard == resource.RLIM_INFINITY else min(limit, hard)
    resource.setrlimit(resource.RLIMIT_CPU, (limit, hard))


def reason(ending, seconds, megabytes):
    """Why a child ended without a word, in a sentence."""
    stage = ending.stage or READING
    if ending.timed_out:
        return f"it was given up in {stage} after {seconds:g} s, as --case-time asks"
    if ending.signal == signal.SIGXCPU and stage == READING:
        return f"{stage} did not end within {READING_SECONDS} s of processor time: the file may be damaged"
    if ending.signal == signal.SIGKILL:
        return f"its process was killed in {stage}: the machine may have had too little memory"
    if ending.signal:
        how = f"crashed ({signal.Signals(ending.signal).name})"
    else:
        how = f"ended its process with exit status {ending.status}"
    if megabytes:
        return f"{stage} {how}: the {megabytes:g} MB of --case-memory may be too few"
    if stage == READING:
        return f"{stage} {how}: the file may be damaged"
    return f"{stage} {how}, which is a fault of the program: please report it with the file"
