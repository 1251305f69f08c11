"""The public headers as data: what they declare, and the comments that say what it means.

The headers keep to these rules, which the reference and the man pages of section 3 are made by:
- A comment on the line before a declaration is about it, and about the declarations that follow it
  without a blank line or another comment between: they are one group.
- A comment behind a declaration, on its line, says more about that declaration alone.
- A comment with a blank line behind it is text of its own: of the header, or of a section, which
  begins with a line of dashes that holds its title.

usage: headers.py INCLUDE  names each public symbol that no comment is about.
"""

import dataclasses
import pathlib
import re
import sys

COMMENT = re.compile(r"/\*(.*?)\*/", re.S)
TITLE = re.compile(r"----+ (.*?) -{2,}\s*(.*)", re.S)
MARKS = re.compile(r"\b(FMB_API|FMB_CHECKED)\s+")


@dataclasses.dataclass
class Member:
    """A member of a structure or a value of an enumeration."""
    text: str
    comment: str


@dataclasses.dataclass
class Item:
    """One declaration."""
    kind: str  # function, variable, macro, struct, enum or type
    name: str
    text: str  # as C, on one line, without body and semicolon
    comment: str = ""  # that stands behind it
    members: list = dataclasses.field(default_factory=list)
    value: str = ""  # of a macro


@dataclasses.dataclass
class Group:
    """Declarations that share a comment."""
    comment: str
    items: list


@dataclasses.dataclass
class Section:
    """A title, and in their order the texts (str) and groups below."""
    title: str
    content: list


@dataclasses.dataclass
class Header:
    """A header: its path as programs include it, what it is, and its sections; the first has no title."""
    path: str
    about: str
    sections: list


def plain(comment):
    """The text of a comment without its stars; lines keep their indentation."""
    lines = [re.sub(r"^\s*\* ?", "", line) if k else line.lstrip() for k, line in enumerate(comment.split("\n"))]
    return "\n".join(line.rstrip() for line in lines).strip("\n ")


def joined(text):
    return " ".join(text.split())


def without_conditions(text):
    """The header without what the preprocessor chooses: guards, includes, and what C++ alone sees."""
    text = re.sub(r"^#ifdef __cplusplus\n.*?^#endif\n", "", text, flags=re.M | re.S)
    text = re.sub(r"^#(?:include|if|ifdef|ifndef|else|elif|endif)\b.*\n", "", text, flags=re.M)
    text = re.sub(r"^#define FMB_\w+_H\n", "", text, flags=re.M)
    return re.sub(r"^#define FMB_(?:API|CHECKED)\b.*\n", "", text, flags=re.M)


def end_of_declaration(text, start):
    """Behind the semicolon that ends the declaration which begins there."""
    depth, at = 0, start
    while True:
        if text.startswith("/*", at):
            at = text.index("*/", at) + 2
            continue
        if text[at] == ";" and depth == 0:
            return at + 1
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        at += 1


def split_members(body, separator):
    """(text, comment) of each member: comments stand before it on lines of their own, or behind it."""
    out, before, at = [], "", 0
    token = re.compile(r"\s*(?:/\*(.*?)\*/|([^" + separator + r"/]+))" + separator + r"?", re.S)
    while at < len(body) and body[at:].strip():
        found = token.match(body, at)
        fresh = "\n" in body[at:found.start(1) if found[1] is not None else found.start(2)] or not out
        at = found.end()
        if found[1] is None:
            if found[2].strip():
                out.append([joined(found[2]), before])
                before = ""
        elif fresh and "\n" in body[found.start():found.end()].split("/*")[0] or not out:
            before = plain(found[1])
        else:
            out[-1][1] = "\n".join(filter(None, (out[-1][1], plain(found[1]))))
    return out


def declarators(text):
    """`long line, column` are two members."""
    if "(" in text or "," not in text:
        return [text]
    first, *rest = [part.strip() for part in text.split(",")]
    kind = re.match(r"(.*?)[*\s]*\w+(?:\[[^\]]*\])*$", first)[1].strip()
    return [first, *(f"{kind} {part}" for part in rest)]


def declaration(text):
    """The item that a declaration is."""
    body = re.search(r"\{(.*)\}", text, re.S)
    if body:
        word, name = re.match(r"(?:typedef )?(struct|enum)\s*(\w*)", text).groups()
        constant = re.match(r"\s*(\w+) = (\w+)\s*$", body[1])
        if not name and constant:
            return Item("macro", constant[1], constant[1], value=constant[2])
        parts = split_members(body[1], "," if word == "enum" else ";")
        members = [Member(one, comment) for part, comment in parts
                   for one in ([part] if word == "enum" else declarators(part))]
        return Item("enum" if word == "enum" else "struct", name, f"{word} {name}".strip(), "", members)
    line = joined(MARKS.sub("", COMMENT.sub("", text)).rstrip("; \n"))
    opaque = re.match(r"typedef struct (\w+) \1$", line)
    if opaque:
        return Item("struct", opaque[1], f"struct {opaque[1]}")
    if line.startswith("typedef "):
        name = re.search(r"\b(fmb_\w+)\(", line) or re.search(r"(\w+)$", line)
        return Item("type", name[1], line[len("typedef "):])
    function = re.search(r"\b(fmb_\w+)\(", line)
    if function:
        return Item("function", function[1], line)
    line = line.replace("extern ", "")
    return Item("variable", re.search(r"\b(fmb_\w+)", line.split("const fmb_rule *")[-1])[1], line)


def declared(text, at):
    """The item at that place, and where it ends."""
    if text.startswith("#define", at):
        end = re.compile(r"(?:[^\n\\]|\\.)*\n", re.S).match(text, at).end()
        line = joined(COMMENT.sub("", text[at:end]).replace("\\\n", " "))
        name, parameters, value = re.match(r"#define (\w+)(\([^)]*\))?(.*)", line).groups()
        return Item("macro", name, name + (parameters or ""), value=value.strip()), end
    end = end_of_declaration(text, at)
    return declaration(text[at:end]), end


def entries(text):
    """What stands in a header, in its order: texts and groups."""
    at, group, comment = 0, None, None
    while True:
        blank = re.compile(r"\s*").match(text, at)
        if comment is not None and blank[0].count("\n") > 1 or blank.end() == len(text):
            if comment is not None:
                yield comment
            comment = None
        if blank[0].count("\n") > 1:
            group = None
        at = blank.end()
        if at == len(text):
            return
        found = COMMENT.match(text, at)
        if found:
            behind = group is not None and "\n" not in blank[0]
            if behind:
                group.items[-1].comment = plain(found[1])
            else:
                if comment is not None:
                    yield comment
                comment, group = plain(found[1]), None
            at = found.end()
            continue
        item, at = declared(text, at)
        if text[at - 1] == "\n":
            at -= 1  # whose line end tells what follows
        if group is None:
            group = Group(comment or "", [])
            comment = None
            yield group  # which is filled until the next comes
        group.items.append(item)


def read(path):
    """A header as data."""
    found = list(entries(without_conditions(path.read_text())))
    assert isinstance(found[0], str), f"{path} does not begin with what it is"
    name, _, about = found[0].partition(": ")
    assert f"fmb/{path.name}" == name, f"{path} begins with {name}"
    header = Header(name, about[0].upper() + about[1:], [Section("", [])])
    for what in found[1:]:
        section = TITLE.match(what) if isinstance(what, str) else None
        if section:
            header.sections.append(Section(section[1].strip(), list(filter(None, [section[2].strip()]))))
        else:
            header.sections[-1].content.append(what)
    return header


def groups(header):
    for section in header.sections:
        yield from (what for what in section.content if isinstance(what, Group))


def elsewhere(item):
    """Is it a structure that the header only names, with a comment that says which header declares it?"""
    return item.kind == "struct" and not item.members and re.fullmatch(r"<fmb/\w+\.h>", item.comment)


def read_all(include):
    """All public headers, by name."""
    out = [read(path) for path in sorted(pathlib.Path(include).glob("fmb/*.h"))]
    for header in out:
        for section in header.sections:
            section.content = [what for what in section.content
                               if isinstance(what, str) or not all(map(elsewhere, what.items))]
    return out


def silent(header):
    """Public symbols without a comment."""
    for group in groups(header):
        for item in group.items:
            if not group.comment and not item.comment:
                yield item.name


def main():
    headers = read_all(sys.argv[1])
    count = sum(len(group.items) for header in headers for group in groups(header))
    faults = [f"{header.path}: {name}: no comment says what it is" for header in headers for name in silent(header)]
    print("\n".join(faults) or f"{count} public symbols, all with a comment")
    sys.exit(bool(faults) or count < 200)


if __name__ == "__main__":
    main()
