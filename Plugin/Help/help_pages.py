# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the pages of ParaView's help: one per filter, from its XML, and the pages of docs/. Run by the build.

    help_pages.py <folder to write to> <repository> <server-manager XML> ...
"""

import html
import re
import shutil
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import markdown
from PIL import Image

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Utilities/docs"))
import reference

LEFT_OUT = ("gallery.md",)  # megabytes of pictures
PAGE_WIDTH = 660  # pixels that the help window shows of a page as it opens
PICTURES = {  # of filters whose guide does not begin with a picture of them
    "ConformalDisk": "tutorial/conformal.png",
    "OMTAreaPreserving": "tutorial/area_preserving.png",
    "DistortionMetrics": "tutorial/table.png",
    "MeshSaliency": "gallery/colon.png",
    "FlattenRegion": "gallery/colon.png",
    "AreaWeights": "gallery/hierarchy.png",
    "FlatMapTransfer": "refinement.png",
    "ImageGaussianSmooth": "tutorial/surface.png",
}


class HelpPages:
    def __init__(self, folder, repository):
        self.folder = Path(folder)
        self.docs = Path(repository) / "docs"
        self.filters = Path(repository) / "Filters"
        self.guides = reference.guides(Path(repository))
        self.pages = sorted(p.name for p in self.docs.glob("*.md") if p.name not in LEFT_OUT)
        self.titles = {}  # of the pages that were written, by file name
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def write(self, name, title, body):
        self.titles[name] = title
        (self.folder / name).write_text(
            '<html><head><meta charset="utf-8"/>'
            f"<title>{html.escape(title)}</title></head>\n<body>\n{body}\n</body></html>\n",
            encoding="utf-8",
        )

    def picture(self, path):
        """Copies a picture to the one folder that help has, no wider than a page, as the help window would cut it
        off; returns its name there."""
        name = path.replace("/", "-")
        with Image.open(self.docs / "pictures" / path) as picture:
            if picture.width <= PAGE_WIDTH:
                shutil.copyfile(picture.filename, self.folder / name)
            else:
                height = round(picture.height * PAGE_WIDTH / picture.width)
                picture.convert("RGB").resize((PAGE_WIDTH, height), Image.LANCZOS).save(self.folder / name)
        return name

    def converted_link(self, match):
        """A link of a page of docs/ becomes a link within help, a picture, or plain text."""
        image, text, target = match.group(1), match.group(2), match.group(3)
        if image and target.endswith(".svg"):
            return f"*{text}*"  # ParaView takes no such pictures into a plugin's help
        if image:
            return f"![{text}]({self.picture(target.removeprefix('pictures/'))})"
        page, _, section = target.partition("#")
        if "://" in target or not page:
            return match.group(0)
        if page in self.pages:
            return f"[{text}]({page.removesuffix('.md')}.html{'#' + section if section else ''})"
        return text

    def write_docs(self):
        for page in self.pages:
            text = (self.docs / page).read_text(encoding="utf-8")
            text = re.sub(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)", self.converted_link, text)
            title = re.match(r"# (.*)", text).group(1)
            body = markdown.markdown(text, extensions=["tables", "fenced_code", "toc", "sane_lists"])
            self.write(page.removesuffix(".md") + ".html", title, body)

    def write_filter(self, group, proxy):
        label = proxy.get("label")
        body = [f"<h1>{html.escape(label)}</h1>", f"<p>{_text(proxy)}</p>"]
        is_of_vtk = not (self.filters / f"{proxy.get('class')}.h").exists()
        guide = self.guides.get(label, "volumes.md" if is_of_vtk else None)
        picture = PICTURES.get(proxy.get("name")) or (self.first_picture(guide) if guide else None)
        if picture:
            body.append(f'<p><img src="{self.picture(picture)}"/></p>')
        if guide:
            link = f'<a href="{guide.removesuffix(".md")}.html">{html.escape(self.title(guide))}</a>'
            body.append(f"<p>Guide: {link}</p>")
        if not is_of_vtk:
            anchor = label.lower().replace(" ", "-") + "-arrays"
            body.append(f'<p>Output: <a href="reference.html#{anchor}">arrays and field data</a></p>')
        body.append('<table border="1" cellpadding="4"><tr><th>setting</th><th>default</th><th>meaning</th></tr>')
        body += [_row(p) for p in proxy if p.tag.endswith("Property") and p.find("Documentation") is not None]
        body.append("</table>")
        self.write(f"{group}.{proxy.get('name')}.html", label, "\n".join(body))

    def title(self, page):
        return re.match(r"# (.*)", (self.docs / page).read_text(encoding="utf-8")).group(1)

    def first_picture(self, page):
        found = re.search(r"\]\(pictures/([^)]+)\)", (self.docs / page).read_text(encoding="utf-8"))
        return found.group(1) if found else None

    def write_index(self):
        filters, others = [], []
        for name, title in sorted(self.titles.items(), key=lambda item: item[1]):
            line = f'<li><a href="{name}">{html.escape(title)}</a></li>'
            (filters if name.count(".") > 1 else others).append(line)
        body = ["<h1>Surface Flattening</h1>", "<h2>Filters</h2><ul>", *filters, "</ul>"]
        self.write("index.html", "Surface Flattening", "\n".join([*body, "<h2>Pages</h2><ul>", *others, "</ul>"]))


def _text(element):
    return html.escape(reference.sentence_of(element))


def _row(setting):
    default = "" if setting.tag == "InputProperty" else reference.values_of(setting)[1]
    cells = (reference.label_of(setting), default.strip("*"))
    return "<tr>" + "".join(f"<td>{html.escape(c)}</td>" for c in cells) + f"<td>{_text(setting)}</td></tr>"


def main():
    pages = HelpPages(sys.argv[1], sys.argv[2])
    pages.write_docs()
    for path in sys.argv[3:]:
        for group in ElementTree.parse(path).getroot().iter("ProxyGroup"):
            if group.get("name") == "internal_filters":  # what the window uses alone
                continue
            for proxy in group.iter("SourceProxy"):
                pages.write_filter(group.get("name"), proxy)
    pages.write_index()


if __name__ == "__main__":
    main()
