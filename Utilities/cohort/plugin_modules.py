# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets Python find the modules of the plugin that the cohort shares: import it before them."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Plugin"))
