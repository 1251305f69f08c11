"""Links of the built site lead somewhere: files that are there, and anchors within them. Links to other
places on the net are listed, not asked for.

usage: links.py SITE
"""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """What a page links to, and the places in it that can be linked to."""

    def __init__(self, path):
        super().__init__()
        self.targets, self.places = [], {"", "top"}
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.places |= {attributes[key] for key in ("id", "name") if attributes.get(key)}
        for key in ("href", "src"):
            if attributes.get(key) and tag != "base":
                self.targets.append(attributes[key])


def faults(site, pages, outside):
    for path, page in pages.items():
        for target in page.targets:
            url = urllib.parse.urlsplit(target)
            if url.scheme or url.netloc:
                outside.setdefault(target, []).append(path)
                continue
            there = path
            if url.path:
                there = (path.parent / urllib.parse.unquote(url.path)).resolve()
            if there.is_dir():
                there /= "index.html"
            if not there.is_file() or site not in there.parents:
                yield f"{path.relative_to(site)}: {target} is not there"
            elif there in pages and urllib.parse.unquote(url.fragment) not in pages[there].places:
                yield f"{path.relative_to(site)}: {target}: no such place in it"


def main():
    site = pathlib.Path(sys.argv[1]).resolve()
    pages = {path: Page(path) for path in sorted(site.rglob("*.html"))}
    outside = {}
    found = sorted(set(faults(site, pages, outside)))
    print("\n".join(found) or f"links: no faults in {len(pages)} pages")
    print(f"links to other places, not asked for: {len(outside)}")
    for target in sorted(outside):
        print(" ", target)
    sys.exit(bool(found) or not pages)


if __name__ == "__main__":
    main()
