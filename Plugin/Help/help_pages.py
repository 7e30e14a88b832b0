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

LEFT_OUT = ("gallery.md",)  # megabytes of pictures
PAGE_WIDTH = 660  # pixels that the help window shows of a page as it opens
PICTURES = {  # of filters whose own page of docs/ begins with no picture of them
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
        self.readme = (Path(repository) / "README.md").read_text(encoding="utf-8")
        self.pages = sorted(p.name for p in self.docs.glob("*.md") if p.name not in LEFT_OUT)
        self.titles = {}  # of what was written, by file name
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

    def reference(self, match):
        """What a reference of a page of docs/ becomes: one within help, a picture, or plain text."""
        image, text, target = match.group(1), match.group(2), match.group(3)
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
            text = re.sub(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)", self.reference, text)
            title = re.match(r"# (.*)", text).group(1)
            body = markdown.markdown(text, extensions=["tables", "fenced_code", "toc", "sane_lists"])
            self.write(page.removesuffix(".md") + ".html", title, body)

    def pages_about(self, label):
        """The pages of docs/ that the README's table of filters names for a filter."""
        row = re.search(rf"^\| {re.escape(label)}, `vtk.*$", self.readme, re.MULTILINE)
        named = re.findall(r"\(docs/(\w+\.md)", row.group(0)) if row else ["volumes.md"]
        return [page for page in dict.fromkeys(named) if page in self.pages]

    def write_filter(self, group, proxy):
        label = proxy.get("label")
        body = [f"<h1>{html.escape(label)}</h1>", f"<p>{_text(proxy)}</p>"]
        about = self.pages_about(label)
        first = [self.first_picture(page) for page in about]
        picture = PICTURES.get(proxy.get("name")) or next(filter(None, first), None)
        if picture:
            body.append(f'<p><img src="{self.picture(picture)}"/></p>')
        links = [f'<a href="{p.removesuffix(".md")}.html">{html.escape(self.title(p))}</a>' for p in about]
        if links:
            body.append(f"<p>More: {'; '.join(links)}</p>")
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
    return html.escape(" ".join((element.findtext("Documentation") or "").split()))


def _row(setting):
    label = setting.get("label") or re.sub(r"(?<=[a-z])(?=[A-Z])", " ", setting.get("name"))
    default = setting.get("default_values") or ""
    names = {e.get("value"): e.get("text") for e in setting.iter("Entry")}
    if setting.find("BooleanDomain") is not None:
        names = {"0": "off", "1": "on"}
    from_data = ("ArrayListDomain", "ArrayRangeDomain", "BoundsDomain", "InputArrayDomain")
    if any(setting.find(domain) is not None for domain in from_data):
        default = ""
    cells = (label, names.get(default, default))
    return "<tr>" + "".join(f"<td>{html.escape(c)}</td>" for c in cells) + f"<td>{_text(setting)}</td></tr>"


def main():
    pages = HelpPages(sys.argv[1], sys.argv[2])
    pages.write_docs()
    for path in sys.argv[3:]:
        for group in ElementTree.parse(path).getroot().iter("ProxyGroup"):
            for proxy in group.iter("SourceProxy"):
                pages.write_filter(group.get("name"), proxy)
    pages.write_index()


if __name__ == "__main__":
    main()
