# SPDX-License-Identifier: GPL-3.0-or-later
"""The library calls its own copies of all functions that it has, such as those of std::vector, and not those of a library
that the process has loaded earlier: check_own_functions.py <library> [readelf]"""

import subprocess
import sys

library, readelf = sys.argv[1], (sys.argv[2:] or ["readelf"])[0]


def listed(option):
    return subprocess.run([readelf, option, "--wide", library], check=True, capture_output=True, text=True).stdout


symbols = [line.split() for line in listed("--dyn-syms").splitlines() if " FUNC " in line and " UND " not in line]
own = {symbol[7].split("@")[0] for symbol in symbols}
assert any("St6vector" in name for name in own), f"{library} has no functions of std::vector"
called = {word for line in listed("--relocs").splitlines() for word in line.split() if word in own}
assert not called, f"{len(called)} of {len(own)} functions may be those of another library: {sorted(called)}"
print(f"{len(own)} functions")
