"""Pages of the reference of C, one a header, from the comments of the public headers.

usage: c_reference.py INCLUDE OUT
"""

import pathlib
import re
import sys

import headers

ROLES = {"function": "func", "variable": "var", "macro": "macro", "struct": "struct", "enum": "enum", "type": "type"}
# What a text names: another header, a document, code between backticks, emphasis, a symbol.
TOKEN = re.compile(r"<fmb/(\w+)\.h>|\bdocs/([a-z-]+)\.md\b|`([^`]+)`|(?<![\w*])\*([A-Za-z][\w ]*\w|\w)\*(?![\w*])"
                   r"|\b((?:fmb|FMB)_\w+)")


def roles(all_headers):
    """The role that links to each public symbol."""
    out = {}
    for header in all_headers:
        for group in headers.groups(header):
            for item in group.items:
                out[item.name] = ROLES[item.kind]
                if item.kind == "enum":
                    out.update({member.text.split()[0]: "enumerator" for member in item.members})
    return out


def escaped(text):
    return re.sub(r"([\\*`_|<>])", r"\\\1", text)


def linked(text, known):
    """A text as reStructuredText, with links to what it names."""
    out, at = [], 0
    for found in TOKEN.finditer(text):
        header, document, code, emphasis, symbol = found.groups()
        if symbol and symbol not in known:
            continue
        out.append(escaped(text[at:found.start()]))
        at = found.end()
        if header:
            piece = f":doc:`\\<fmb/{header}.h\\> </reference/c/{header}>`"
        elif document:
            piece = f":doc:`{document} </background/{document}>`"
        elif code:
            piece = f"``{code}``"
        elif emphasis:
            piece = f"*{emphasis}*"
        else:
            piece = f":c:{known[symbol]}:`{symbol}`"
        # Marks need blanks or some punctuation around them.
        before = "" if out[-1][-1:] in "\n \"'([{<-/:" else "\\ "
        behind = "" if text[at:at + 1] in "\n \"')]}>-/:.,;!?" else "\\ "
        out.append(before + piece + behind)
    out.append(escaped(text[at:]))
    return "".join(out)


def prose(text, known):
    """Paragraphs of a comment; what is indented is code."""
    out = []
    for paragraph in re.split(r"\n\s*\n", text):
        lines = paragraph.split("\n")
        head = [line for line in lines if not line.startswith("  ")]
        if paragraph.startswith("  "):
            out += ["::", "", *("    " + line for line in lines), ""]
        elif paragraph.startswith("- "):
            out += [*(linked(line, known) for line in lines), ""]
        else:
            out += [linked(" ".join(line.strip() for line in (head if len(head) == len(lines) else lines)), known), ""]
    return out


def indented(lines, by="   "):
    return [by + line if line else line for line in lines]


def members(item, known):
    word = "enumerator" if item.kind == "enum" else "member"
    for member in item.members:
        yield from (f".. c:{word}:: {member.text}", "")
        yield from indented(prose(member.comment, known)) if member.comment else ()


def described(items, comment, known):
    """Items under one directive: signatures, comment, what stands behind each, members."""
    word = {"function": "function", "variable": "var", "macro": "macro", "struct": "struct", "enum": "enum",
            "type": "type"}[items[0].kind]
    signatures = [item.name if item.kind in ("struct", "enum") else item.text for item in items]
    yield f".. c:{word}:: {signatures[0]}"
    yield from indented(signatures[1:], " " * len(f".. c:{word}:: "))
    yield ""
    body = prose(comment, known) if comment else []
    for item in items:
        name = f"``{item.name}``: " if len(items) > 1 else ""
        if item.comment:
            body += [name + linked(" ".join(item.comment.split()), known), ""]
        if item.value:
            body += [f"{name}The value is ``{item.value}``.", ""]
        body += members(item, known)
    yield from indented(body)


def group_lines(group, known):
    """A group under one directive, if all of it is of one kind and without members; else an item at a time."""
    kinds = {item.kind for item in group.items}
    if len(kinds) == 1 and (len(group.items) == 1 or not any(item.members for item in group.items)):
        yield from described(group.items, group.comment, known)
        return
    yield from prose(group.comment, known) if group.comment else ()
    for item in group.items:
        yield from described([item], "", known)


def page(header, known):
    title = f"<{header.path}>"
    yield from (title, "=" * len(title), "", *prose(header.about, known))
    for section in header.sections:
        if section.title:
            name = escaped(section.title[0].upper() + section.title[1:])
            yield from (name, "-" * len(name), "")
        for what in section.content:
            yield from prose(what, known) if isinstance(what, str) else group_lines(what, known)


def main():
    include, out = sys.argv[1], pathlib.Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    all_headers = headers.read_all(include)
    known = roles(all_headers)
    for header in all_headers:
        name = pathlib.Path(header.path).stem
        (out / f"{name}.rst").write_text("\n".join(page(header, known)) + "\n")


if __name__ == "__main__":
    main()
