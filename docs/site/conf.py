"""How Sphinx makes the site (docs/site/build)."""

import pathlib
import re

from pygments.lexer import RegexLexer, bygroups
from pygments.lexers.special import TextLexer
from pygments.token import Comment, Generic

ROOT = pathlib.Path(__file__).resolve().parents[2]

project = "libfmb"
author = copyright = "the authors of libfmb"  # pylint: disable=redefined-builtin
release = version = re.search(r"version: '([^']*)'", (ROOT / "meson.build").read_text())[1]

extensions = ["myst_parser", "sphinx.ext.autodoc"]
exclude_patterns = ["files"]
myst_heading_anchors = 4
# Tables of the documents are as wide as they need to be; what is between quotation marks stays as it is.
smartquotes = False
add_function_parentheses = False
# What Python's docstrings put between single backticks is code.
default_role = "literal"
autodoc_member_order = "bysource"
autodoc_typehints_format = "short"
python_use_unqualified_type_names = True
autodoc_type_aliases = {name: name for name in ("FormLike", "Names", "Number", "RowLike", "SystemLike")}
toc_object_entries_show_parents = "hide"

html_theme = "fmb"
html_theme_path = ["make/theme"]
html_title = f"libfmb {release}"
html_copy_source = False


class Transcript(RegexLexer):
    """What was typed behind a prompt, and what came back."""

    name = "transcript"
    tokens = {"root": [(r"^(\$ |> )(.*\n)", bygroups(Generic.Prompt, Generic.Strong)),
                       (r"^! .*\n", Generic.Error), (r"^\[exit \d+\]\n", Comment), (r".*\n", Generic.Output)]}


def within_reach(app, pagename, templatename, context, doctree):
    """Whoever has no mouse scrolls wide blocks and tables once these can be chosen by the keyboard; and a table
    has no heading without a word."""
    if "body" in context:
        body = context["body"].replace("<pre>", '<pre tabindex="0">')
        body = body.replace('<th class="head"><p></p></th>', "<td></td>")
        body = re.sub(r"<table class=\"docutils.*?</table>", r'<div class="scroll" tabindex="0">\g<0></div>', body, flags=re.S)
        context["body"] = body


def setup(app):
    """The languages of the project: what is read by fmb is shown as it is."""
    for language in ("fmb", "proof"):
        app.add_lexer(language, TextLexer)
    app.add_lexer("console", Transcript)
    app.connect("html-page-context", within_reach)
