"""Answers in notebooks."""

from __future__ import annotations

from html import escape
from typing import Sequence

MOST = 50


def table(lines: Sequence[str], title: str = "") -> str:
    """A line each, at most MOST of them."""
    shown = [f"<tr><td style='text-align:left'>{escape(line)}</td></tr>" for line in lines[:MOST]]
    if len(lines) > MOST:
        shown.append(f"<tr><td>… {len(lines) - MOST} more</td></tr>")
    caption = f"<caption>{escape(title)}</caption>" if title else ""
    return f"<table>{caption}{''.join(shown)}</table>"
