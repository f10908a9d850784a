"""Builds the site and walks it: do all links and anchors lead somewhere, is each page reached from the first one, and
does no page load anything from the network?

check_site.py. The pages in Markdown are also looked at for marks that have stayed in the text, as GitHub reads some
forms of lists and tables that mkdocs does not.
"""
import html.parser
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Attributes whose files a browser loads with the page. Of the kinds of <link>, only some load.
LOADING = {"src", "srcset", "poster", "data", "background", "xlink:href"}
LOADING_LINKS = {"stylesheet", "icon", "shortcut", "preload", "prefetch", "preconnect", "dns-prefetch", "modulepreload"}
LOADING_LINKS |= {"manifest", "apple-touch-icon"}
REMOTE = re.compile(r"\s*(?:https?:|wss?:|ftp:|//)", re.IGNORECASE)
STYLE_LOADS = re.compile(r"""(?:@import\s+|url\(\s*)["']?((?:https?:)?//[^"')\s]+)""", re.IGNORECASE)
MARKS = re.compile(r"^\s*(?:[-*+] |\d+\. |\|)|\]\(|```|\*\*|\[\w+\]:", re.MULTILINE)
# mkdocs writes the first for servers, which show it in place of a missing page; Doxygen's search opens others; the last
# are licences of scripts.
NOT_WALKED = re.compile(r"404\.html|reference/(?:c|cpp)/search/.*|reference/java/legal/.*")
# Scripts of the theme load these where a page asks for them.
ASKS_FOR_REMOTE = {"mermaid", "md-source"}


class Page(html.parser.HTMLParser):
    """What a page refers to, loads and has anchors for, and the text of its paragraphs."""

    def __init__(self, path):
        super().__init__(convert_charrefs=True)
        self.links, self.loads, self.anchors, self.paragraphs, self.asks = [], [], set(), [], set()
        self.open_paragraph, self.in_code, self.in_style = None, 0, False
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = {name: value or "" for name, value in attributes}
        self.anchors |= {values[name] for name in ("id", "name") if name in values}
        self.asks |= ASKS_FOR_REMOTE & set(values.get("class", "").split())
        if tag in ("a", "area", "iframe") and "href" in values:
            self.links.append(values["href"])
        if tag == "iframe" and "src" in values:
            self.links.append(values["src"])
        if tag == "link" and LOADING_LINKS & set(values.get("rel", "").lower().split()):
            self.loads.append(values.get("href", ""))
        self.loads += [value for name, value in values.items() if name in LOADING]
        self.loads += STYLE_LOADS.findall(values.get("style", ""))
        self.in_style = tag == "style"
        self.in_code += tag in ("code", "pre")
        if tag == "p":
            self.open_paragraph = ""

    def handle_endtag(self, tag):
        self.in_code -= tag in ("code", "pre")
        self.in_style = False
        if tag == "p" and self.open_paragraph is not None:
            self.paragraphs.append(self.open_paragraph)
            self.open_paragraph = None

    def handle_data(self, text):
        if self.in_style:
            self.loads += STYLE_LOADS.findall(text)
        if self.open_paragraph is not None and not self.in_code:
            self.open_paragraph += text


class Site:
    def __init__(self, folder):
        self.folder = folder
        self.pages = {path: Page(path) for path in sorted(folder.rglob("*.html"))}
        self.faults = []

    def tell(self, path, what):
        self.faults.append(f"{path.relative_to(self.folder)}: {what}")

    def goal(self, path, link):
        """File and anchor of a link; None for what leads out of the site or calls a script."""
        parts = urllib.parse.urlsplit(link)
        if parts.scheme or parts.netloc:
            return None
        name = urllib.parse.unquote(parts.path)
        goal = path
        if name:
            goal = pathlib.Path(os.path.normpath(self.folder / name[1:] if name[0] == "/" else path.parent / name))
        return (goal / "index.html" if goal.is_dir() else goal), urllib.parse.unquote(parts.fragment)

    def check_links(self):
        for path, page in self.pages.items():
            for link in page.links + page.loads:
                found = self.goal(path, link)
                if not found:
                    continue
                goal, anchor = found
                if not goal.is_relative_to(self.folder) or not goal.is_file():
                    self.tell(path, f"a link to {link}")
                elif anchor and goal in self.pages and anchor not in self.pages[goal].anchors:
                    self.tell(path, f"a link to {link}, where there is no such anchor")

    def check_reach(self):
        first = self.folder / "index.html"
        reached, waiting = {first}, [first]
        while waiting:
            path = waiting.pop()
            goals = {found[0] for found in (self.goal(path, link) for link in self.pages[path].links) if found}
            new = {goal for goal in goals if goal in self.pages} - reached
            reached |= new
            waiting += new
        for path in self.pages.keys() - reached:
            if not NOT_WALKED.fullmatch(path.relative_to(self.folder).as_posix()):
                self.tell(path, "no way from the first page leads here")

    def check_loads(self):
        for path, page in self.pages.items():
            for load in page.loads:
                if REMOTE.match(load):
                    self.tell(path, f"loads {load}")
            for name in page.asks:
                self.tell(path, f"the class {name}, for which the theme loads from the network")
        for path in self.folder.rglob("*.css"):
            for load in STYLE_LOADS.findall(path.read_text(encoding="utf-8")):
                self.tell(path, f"loads {load}")

    def check_marks(self):
        for path, page in self.pages.items():
            if re.match(r"reference/(?:c|cpp|java)/", path.relative_to(self.folder).as_posix()):
                continue
            for text in page.paragraphs:
                if MARKS.search(text):
                    self.tell(path, f"marks in the text: {text.strip()[:90]!r}")

    def check_search(self):
        index = json.loads((self.folder / "search/search_index.json").read_text())
        found = {entry["location"].partition("#")[0] for entry in index["docs"]}
        for name in ("index.html", "docs/guide.html", "reference/python/meshes.html", "reference/csharp/Mesh.html"):
            if name not in found:
                self.faults.append(f"the search does not know {name}")


def main():
    with tempfile.TemporaryDirectory() as folder:
        if subprocess.run((sys.executable, "-B", ROOT / "tools/site/build.py", folder)).returncode:
            sys.exit("the site cannot be built")
        site = Site(pathlib.Path(folder).resolve())
        site.check_links()
        site.check_reach()
        site.check_loads()
        site.check_marks()
        site.check_search()
        links = sum(len(page.links) for page in site.pages.values())
        print(f"{len(site.pages)} pages, {links} links")
        if site.faults:
            sys.exit("\n".join(sorted(site.faults)))
        if len(site.pages) < 200 or links < 10000:
            sys.exit("there are too few pages or links to be true")


main()
