// SPDX-License-Identifier: GPL-3.0-or-later
/// Defaults of ParaView that the plugin changes when it is loaded, in the window and in scripts.
#pragma once

/// Adds colour maps for the arrays of the plugin, and saves VTK XML files as binary, to ParaView's
/// default settings. A setting of the user takes precedence.
void surfaceFlatteningDefaults();
