"""The manual of the command `fmb`, from its man page: mandoc makes HTML of that, whose sections are added to
a page of the site.

usage: command.py MAN PAGE
"""

import pathlib
import re
import subprocess
import sys

ACRONYMS = {"JSON"}


def sections(html):
    """(title, HTML) of each section."""
    body = html[html.index('<section class="Sh">'):]
    for piece in body.split('<section class="Sh">')[1:]:
        title = re.search(r'<h1 class="Sh" id="[^"]*"><a[^>]*>(.*?)</a></h1>', piece, re.S)
        inner = piece[title.end():].rpartition("</section>")[0]
        yield " ".join(title[1].split()), inner


def main():
    man, page = sys.argv[1], pathlib.Path(sys.argv[2])
    html = subprocess.run(["mandoc", "-T", "html", "-O", "fragment", man], check=True, capture_output=True,
                          text=True).stdout
    found = list(sections(html))
    assert len(found) > 5, "mandoc's HTML was not understood"
    with page.open("a") as out:
        for title, inner in found:
            inner = inner.replace("<h2 ", "<h3 ").replace("</h2>", "</h3>")
            out.write(f"\n## {title if title in ACRONYMS else title.capitalize()}\n\n````{{raw}} html\n{inner}\n````\n")


if __name__ == "__main__":
    main()
