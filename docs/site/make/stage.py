"""Put the pages of the site where Sphinx reads them, and turn their links there.

Pages are written so that their links work in the tree of the sources. In the site docs/site/ is the root,
docs/*.md are its background/, and whatever else is linked to in the tree is a file to download.

usage: stage.py ROOT OUT
"""

import pathlib
import re
import shutil
import sys

FENCE = re.compile(r"^(```.*?^```$)", re.M | re.S)
NAMED = re.compile(r"\[([\w/.-]+\.md)\]\(\1\)")
ANCHOR = re.compile(r'^<a id="([^"]*)"></a>', re.M)
LINK = re.compile(r"(\]\()([^)#\s]*)((?:#[^)\s]*)?\))")
# Documents of the tree that the site has under other names, or says in another page.
MOVED = {"README.md": "index.md", "bench/README.md": "background/bench.md",
         "bindings/wasm/README.md": "guide/browser.md", "bindings/wasm/npm/README.md": "guide/npm.md"}


def place(root, path):
    """Where a file of the tree stands in the site, from its root."""
    inside = path.relative_to(root)
    if str(inside) in MOVED:
        return pathlib.Path(MOVED[str(inside)])
    if inside.parts[:2] == ("docs", "site"):
        return pathlib.Path(*inside.parts[2:])
    if inside.parent == pathlib.Path("docs"):
        return pathlib.Path("background", inside.name)
    return pathlib.Path("files", inside)


class Stage:
    """The folder that is filled."""

    def __init__(self, root, out):
        self.root, self.out = root, out

    def link(self, source, found):
        """A link of that document, turned to where its target is in the site."""
        before, target, behind = found.groups()
        if not target or "://" in target or target.startswith("mailto:"):
            return found[0]
        path = (source.parent / target).resolve()
        if "." not in target:
            return found[0]  # an anchor
        if not path.is_file():
            sys.exit(f"{source}: {target} is no file")
        there = place(self.root, path)
        if path.suffix != ".md":
            self.file(path)
        up = len(place(self.root, source).parts) - 1
        return f"{before}{'../' * up}{there}{behind}"

    def document(self, source):
        """A page, with its links turned; fenced blocks stay as they are. What HTML calls an anchor at the begin
        of a paragraph MyST writes in another way. A link that only names its file gets the title of the page."""
        text = NAMED.sub(r"[](\1)", source.read_text())
        for name in ANCHOR.findall(text):
            text = text.replace(f"](#{name})", f"]({source.stem}-{name})")
        pieces = FENCE.split(ANCHOR.sub(rf"({source.stem}-\1)=\n", text))
        pieces[::2] = [LINK.sub(lambda found: self.link(source, found), piece) for piece in pieces[::2]]
        there = self.out / place(self.root, source)
        there.parent.mkdir(parents=True, exist_ok=True)
        there.write_text("".join(pieces))

    def file(self, source):
        there = self.out / place(self.root, source)
        there.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, there)


def main():
    root, out = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    stage = Stage(root, out)
    docs = sorted((root / "docs").glob("*.md"))
    site = [path for path in sorted((root / "docs/site").rglob("*")) if path.is_file() and "make" not in path.parts]
    elsewhere = [root / name for name, there in MOVED.items() if there != "index.md"]
    for path in [*docs, *site, *elsewhere]:
        if path.suffix == ".md":
            stage.document(path)
        else:
            stage.file(path)


if __name__ == "__main__":
    main()
