"""How Sphinx makes the site (docs/site/build)."""

import pathlib
import re

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

html_theme = "furo"
html_title = f"libfmb {release}"
html_static_path = ["make/static"]
html_css_files = ["site.css"]
html_show_copyright = html_show_sphinx = False
html_copy_source = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#0b5394", "color-brand-content": "#0b5394"},
    "dark_css_variables": {"color-brand-primary": "#8ab8ff", "color-brand-content": "#8ab8ff"},
}


def setup(app):
    """What the project's own languages are written in is shown as it is."""
    from pygments.lexers.special import TextLexer
    for language in ("fmb", "proof"):
        app.add_lexer(language, TextLexer)
