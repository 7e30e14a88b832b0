# SPDX-License-Identifier: GPL-3.0-or-later
"""Kills a small cohort at random moments, on one rank and on two, and checks that nothing is lost and nothing done twice:

    PYTHONPATH=build/lib/python3/dist-packages python3 Utilities/campaigns/kill_cohort.py --kills 200 --seed 1

A run is killed with SIGKILL (the whole of it, mpiexec, one rank, or the process of a case) and started again with the
same command, at once or when all its processes have ended, until one run comes to its end. Then every case that was
finished at some kill must still be the same file, summary.csv and the results must have the bytes of a run that nobody
disturbed, and no temporary file may be left. Needs Linux. The exit status is 0 if all this holds.
"""

import argparse
import collections
import os
import random
import re
import shutil
import sys
import tempfile
import time

from cohort_runs import Run, content, finished, litter, make_surfaces, results

LONGEST = 120.0  # seconds that a run may take
VICTIMS = ("all", "first", "rank", "case")


class Campaign:
    def __init__(self, scratch, seed):
        self.scratch = scratch
        self.random = random.Random(seed)
        self.files = make_surfaces(os.path.join(scratch, "surfaces"))
        self.counts = collections.Counter()
        self.faults = []
        self.expected = {}
        self.seconds = {}  # that the work on the cases takes
        self.run_goes_on = False  # after the last kill

    def undisturbed(self, ranks):
        output = os.path.join(self.scratch, f"undisturbed{ranks}")
        run = Run(ranks, output, self.files, self.scratch)
        while not self.at_work(output):
            assert run.status(0.02) is None, run.text()
        began = time.monotonic()
        assert run.status(LONGEST) == 1, run.text()  # one file is damaged
        self.seconds[ranks] = time.monotonic() - began
        self.expected[ranks] = (content(os.path.join(output, "summary.csv")), results(output))

    def fault(self, text, run):
        self.faults.append(text)
        print(f"FAULT: {text}\n{run.text()}", flush=True)

    def chain(self, kills):
        """Kills runs in one folder until one comes to its end, or so many are killed; then lets one end."""
        ranks = self.random.choice((1, 2))
        output = os.path.join(self.scratch, "output")
        shutil.rmtree(output, ignore_errors=True)
        known = {}
        while True:
            run = Run(ranks, output, self.files, self.scratch)
            killed = kills > 0 and self.kill(run, ranks)
            kills -= killed
            if not killed or self.run_goes_on:
                self.wait(run)
            elif self.random.random() < 0.5 and run.survivors(20):
                self.fault("processes of a killed run lived on", run)
            self.check_known(known, output, run)
            if not killed:
                break
        self.check_end(ranks, output, run)
        return kills

    def kill(self, run, ranks):
        """Kills some of a run at a random moment; False if it came to its end before."""
        moment = self.random.uniform(0, 1.1)  # of the work on the cases; a tenth of the runs is killed before it
        if moment > 0.1:
            while run.status(0) is None and not self.at_work(run.output):
                time.sleep(0.02)
            moment -= 0.1
        if run.status(moment * self.seconds[ranks]) is not None:
            return False
        self.counts["kills with a case at work"] += self.at_work(run.output)
        victim = self.random.choice(VICTIMS)
        levels = run.processes()
        ranks_at = 1 if ranks > 1 else 0
        groups = {"all": sum(levels, []), "first": levels[0] if levels else [],
                  "rank": self.one(levels, ranks_at), "case": self.one(levels, ranks_at + 1)}
        pids = groups[victim] or groups["all"]
        victim = victim if groups[victim] else "all"
        run.kill(pids)
        self.counts[f"kills on {ranks} rank{'s' * (ranks > 1)}: {victim}"] += 1
        self.run_goes_on = victim == "case"
        return True

    def at_work(self, output):
        folder = os.path.join(output, "cases")
        return os.path.isdir(folder) and any(name.endswith(".started") for name in os.listdir(folder))

    def one(self, levels, depth):
        return [self.random.choice(levels[depth])] if len(levels) > depth and levels[depth] else []

    def wait(self, run):
        if run.status(LONGEST) is None:
            self.fault("a run did not end", run)
            run.survivors(0)

    def check_known(self, known, output, run):
        now = finished(output)
        for name, state in known.items():
            if now.get(name) != state:
                self.fault(f"{name} was finished and is {'lost' if name not in now else 'done again'}", run)
        known.clear()
        known.update(now)
        done = re.findall(r"^\[rank \d+\] \d+/\d+ (\S+): ", run.text(), re.MULTILINE)
        if len(set(done)) < len(done):
            self.fault("a case was done twice in one run", run)

    def check_end(self, ranks, output, run):
        self.counts["runs to the end"] += 1
        summary, flat = self.expected[ranks]
        if run.status(0) != 1:
            self.fault(f"exit status {run.status(0)} instead of 1", run)
        elif content(os.path.join(output, "summary.csv")) != summary:
            self.fault("summary.csv has other bytes", run)
        if results(output) != flat:
            self.fault("the results have other bytes", run)
        if litter(output):
            self.fault(f"left behind: {litter(output)}", run)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        campaign = Campaign(scratch, arguments.seed)
        for ranks in (1, 2):
            campaign.undisturbed(ranks)
        if campaign.expected[1] != campaign.expected[2]:
            campaign.faults.append("one rank and two give other bytes")
        left = arguments.kills
        while left > 0 and len(campaign.faults) < 10:
            most = min(left, campaign.random.randint(1, 4))
            left -= most - campaign.chain(most)
    for name, count in sorted(campaign.counts.items()):
        print(f"{count:6} {name}")
    print(f"{len(campaign.faults)} faults (seed {arguments.seed})")
    return 1 if campaign.faults else 0


if __name__ == "__main__":
    sys.exit(main())
