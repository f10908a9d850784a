"""The pages of the site: copies of those of the repository, at the same places, so that most links hold as they are.

A link to a source leads to a page that shows it, and a link to a folder to the page in it.
"""
import os
import re
import shutil

PATTERNS = ("*.md", "docs/*.md", "docs/decisions/*.md", "examples/*.md", "bindings/*.md", "tests/*/README.md")
LINK = re.compile(r"(!?\]\()([^)\s#]+)(#[^)\s]*)?\)")
VIEW = re.compile(r"^<!-- view: (\w+) -->\n", re.MULTILINE)
FENCE = re.compile(r"(^```.*?^```$)", re.DOTALL | re.MULTILINE)
LEXERS = {".h": "c", ".hpp": "cpp", ".csproj": "xml", ".abi": "xml", ".map": "text", ".f90": "fortran", ".cff": "yaml"}


def show_source(root, output, name):
    """A page that shows a file of the repository."""
    page = output / (name + ".md")
    if page.exists():
        return
    page.parent.mkdir(parents=True, exist_ok=True)
    suffix = os.path.splitext(name)[1]
    lexer = LEXERS.get(suffix, suffix[1:] or "text")
    text = (root / name).read_text()
    fence = "`" * 5
    page.write_text(f"# {name}\n\n{fence}{lexer}\n{text}{fence}\n")


class Copier:
    def __init__(self, root, output):
        self.root, self.output = root, output

    def target(self, page, link):
        """Where a link of a page leads in the site; what it leads to is put there."""
        if re.match(r"[a-z]+:", link):
            return link
        path = (page.parent / link).resolve()
        if not path.exists():
            raise SystemExit(f"{page.relative_to(self.root)}: a link to {link}")
        name = path.relative_to(self.root).as_posix()
        if path.is_dir():
            return link.rstrip("/") + "/README.md"
        if path.suffix == ".md":
            return link
        if path.suffix in (".png", ".svg"):
            (self.output / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, self.output / name)
            return link
        show_source(self.root, self.output, name)
        return link + ".md"

    def copy(self, page):
        def resolved(found):
            return f"{found[1]}{self.target(page, found[2])}{found[3] or ''})"

        parts = FENCE.split(page.read_text())
        parts[::2] = [LINK.sub(resolved, part) for part in parts[::2]]
        copy = self.output / page.relative_to(self.root)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text("".join(parts))


def link_views(page, views):
    """Puts the views of a folder beside the gallery, where the page has a comment for each, with a link."""

    def link(found):
        view = views / f"{found[1]}.html"
        if not view.exists():
            raise SystemExit(f"{view} is missing: benchmarks/gallery.py --views {views}")
        (page.parent / "gallery").mkdir(exist_ok=True)
        shutil.copy(view, page.parent / "gallery")
        return f"[Open the view of {found[1]}](gallery/{view.name})\n\n"

    if views:
        page.write_text(VIEW.sub(link, page.read_text()))


def copy_all(root, output):
    copier = Copier(root, output)
    for pattern in PATTERNS:
        for page in sorted(root.glob(pattern)):
            copier.copy(page)
