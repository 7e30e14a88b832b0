# SPDX-License-Identifier: GPL-3.0-or-later
"""What there is in ParaView at a time, to go back to it when something fails, and names that are not used yet.

The module comes with the plugin. Flatten and Compare uses it to be taken back in one step.
"""

from dataclasses import dataclass

import surfaceflattening_selection
from paraview import servermanager, simple

LINK = "Flatten and Compare"  # name of the selection links


class FilterFailed(RuntimeError):
    """A filter has no output; its message is in ParaView's output window already."""


@dataclass
class Present:
    """What there is at a time; the source that is active, and its layout."""

    sources: set
    layouts: set
    links: set
    active: object
    view: object

    @staticmethod
    def now(active):
        return Present(
            sources={proxy.SMProxy for proxy in simple.GetSources().values()},
            layouts={layout.SMProxy for layout in simple.GetLayouts().values()},
            links=set(links()),
            active=active,
            view=simple.GetActiveView(),
        )

    def restore(self):
        """Removes what was made since then."""
        surfaceflattening_selection.stop(self.sources)
        manager = servermanager.ProxyManager()
        for name in set(links()) - self.links:
            manager.UnRegisterLink(name)
        for layout in list(simple.GetLayouts().values()):
            if layout.SMProxy not in self.layouts:
                for view in simple.GetViewsInLayout(layout):
                    simple.Delete(view)
                simple.RemoveLayout(layout)
        for proxy in reversed(list(simple.GetSources().values())):
            if proxy.SMProxy not in self.sources:
                simple.Delete(proxy)
        if self.view is not None and self.view in simple.GetRenderViews():
            simple.SetActiveView(self.view)
        simple.SetActiveSource(self.active)


def links():
    """The names of the selection links that flatten_and_compare() makes."""
    manager = servermanager.ProxyManager()
    names = (LINK if number == 1 else f"{LINK} {number}" for number in range(1, 100))
    return [name for name in names if manager.GetRegisteredLink(name) is not None]


def unused(name, group="sources"):
    """The name, or with the first number that makes it one that no other proxy of the group has."""
    manager = servermanager.ProxyManager()
    number, free = 1, name
    while manager.GetProxy(group, free) is not None:
        number += 1
        free = f"{name} {number}"
    return free
