# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: makes ParaView's main window 640 pixels wide, as a user's drag at its border does."""

import ctypes

WIDTH, HEIGHT = 640, 760

x11 = ctypes.CDLL("libX11.so.6")
x11.XOpenDisplay.restype = ctypes.c_void_p
display = ctypes.c_void_p(x11.XOpenDisplay(None))
Window = ctypes.c_ulong


def children(window):
    root, parent, count = Window(), Window(), ctypes.c_uint()
    found = ctypes.POINTER(Window)()
    x11.XQueryTree(
        display, window, ctypes.byref(root), ctypes.byref(parent), ctypes.byref(found), ctypes.byref(count)
    )
    return [Window(found[k]) for k in range(count.value)]


def name(window):
    text = ctypes.c_char_p()
    return text.value or b"" if x11.XFetchName(display, window, ctypes.byref(text)) else b""


x11.XDefaultRootWindow.restype = Window
main = [window for window in children(Window(x11.XDefaultRootWindow(display))) if name(window).startswith(b"ParaView")]
assert main, "no window of ParaView"
x11.XResizeWindow(display, main[0], WIDTH, HEIGHT)
x11.XSync(display, 0)
x11.XCloseDisplay(display)
