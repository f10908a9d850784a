"""A hook of mkdocs: a folder in the navigation becomes the list of its pages."""
import pathlib


def title(page):
    return page.read_text().partition("\n")[0].lstrip("# ")


def expanded(entry, pages):
    """An entry of the navigation with a list for a folder; the page on the folder comes first."""
    if isinstance(entry, dict):
        return {name: expanded(value, pages) for name, value in entry.items()}
    if isinstance(entry, list):
        return [expanded(value, pages) for value in entry]
    if not entry.endswith("/"):
        return entry
    names = sorted((pages / entry).glob("*.md"), key=lambda page: (page.name != "README.md", page.name))
    return [{title(page): f"{entry}{page.name}"} for page in names]


def on_config(config):
    config["nav"] = expanded(config["nav"], pathlib.Path(config["docs_dir"]))
    return config
