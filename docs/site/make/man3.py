"""Man pages of section 3 from the comments of the public headers: one for each group of declarations that
share a comment, found under the name of each; and fmb(3), which lists them.

usage: man3.py INCLUDE OUT; as an install script of meson, OUT lies in the prefix.
"""

import os
import pathlib
import re
import sys
import textwrap

import headers


def escaped(text):
    """A line of roff that says this and nothing else."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text[:1] in (".", "'") else text


def code(lines):
    return [".nf", *(escaped(line) for line in lines), ".fi"]


def prose(text):
    """Paragraphs of a comment; what is indented is code."""
    out = []
    for paragraph in re.split(r"\n\s*\n", text):
        if paragraph.startswith("  "):
            out += [".PP", *code(paragraph.split("\n"))]
        else:
            out += [".PP", *map(escaped, textwrap.wrap(" ".join(paragraph.split()), 78, break_on_hyphens=False))]
    return out[1:]


def written(item):
    """The declaration as a program has it."""
    if item.kind == "macro":
        return [f"#define {item.text} {item.value}".rstrip()]
    if not item.members:
        mark = "typedef " if item.kind in ("type", "struct") else ""
        name = f" {item.name}" if item.kind == "struct" else ""
        return textwrap.wrap(f"{mark}{item.text}{name};", 78, subsequent_indent="    ", break_on_hyphens=False)
    end = "," if item.kind == "enum" else ";"
    return [f"typedef {item.text} {{", *(f"    {member.text}{end}" for member in item.members), f"}} {item.name};"]


def summary(group, names):
    """The first sentence about a group."""
    text = group.comment or group.items[0].comment
    text = re.sub(r"^\[give[^]]*\] ", "", " ".join(text.split()))
    return re.match(r"(.*?[.:;?])(?:\s|$)|.*", text)[0].rstrip(" .:;") or names


def page(header, group, version):
    names = [item.name for item in group.items]
    out = [f'.TH {names[0]} 3 "" "libfmb {version}" "libfmb"', ".SH NAME",
           escaped(", ".join(names)) + " \\- " + escaped(summary(group, names[0])), ".SH SYNOPSIS",
           *code([f"#include <{header.path}>", "", *(line for item in group.items for line in written(item))])]
    said = [item for item in group.items if item.comment]
    if group.comment or said:
        out.append(".SH DESCRIPTION")
    out += prose(group.comment) if group.comment else []
    for item in said:
        out += [".TP", f".B {item.name}", *prose(item.comment)]
    for item in group.items:
        told = [member for member in item.members if member.comment]
        out += [".SH VALUES" if item.kind == "enum" else ".SH MEMBERS"] if told else []
        for member in told:
            out += [".TP", f".B {escaped(member.text)}", *prose(member.comment)]
    return [*out, ".SH SEE ALSO", ".BR fmb (3)"]


def overview(all_headers, version):
    out = [f'.TH fmb 3 "" "libfmb {version}" "libfmb"', ".SH NAME",
           "fmb \\- systems of linear inequalities and pairs of frames, exactly and with proofs", ".SH SYNOPSIS",
           *code(["#include <fmb/fmb.h>", "#include <fmb/geometry.h>", "", "cc program.c $(pkg-config --cflags --libs fmb)"])]
    base = next(header for header in all_headers if header.path == "fmb/base.h")
    out += [".SH DESCRIPTION", *prose(base.about), ".SH HEADERS",
            "Each name below has a page of its own in section 3 of the manual."]
    for header in all_headers:
        names = [item.name for group in headers.groups(header) for item in group.items]
        out += [f".SS <{header.path}>", *prose(header.about.split("\n\n")[0])]
        out += [".PP", *map(escaped, textwrap.wrap(", ".join(names), 78))] if names else []
    return [*out, ".SH SEE ALSO", ".BR fmb (1)"]


def pages(include):
    """(file name, text) of every page."""
    all_headers = headers.read_all(include)
    version = re.search(r'define FMB_VERSION +"(.*?)"', pathlib.Path(include, "fmb/base.h").read_text())[1]
    yield "fmb.3", overview(all_headers, version)
    for header in all_headers:
        for group in headers.groups(header):
            first, *others = [item.name for item in group.items]
            yield f"{first}.3", page(header, group, version)
            for name in others:
                yield f"{name}.3", [f".so man3/{first}.3"]


def main():
    include, out = sys.argv[1], pathlib.Path(os.environ.get("MESON_INSTALL_DESTDIR_PREFIX", ""), sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    for name, lines in pages(include):
        (out / name).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
