"""Programs in the pages of the site do what they show, each page in a fresh folder that holds the examples
and what lies beside the page. A block of Python is an example in the manner of doctest; all blocks of a page
see the names of those before. A block of C is a whole program, which is compiled, ends with 0, and prints the
block of text behind it. Blocks of other languages are played elsewhere (console: transcripts.py), or are no programs: a language that is not
known here is a fault.

usage: programs.py ROOT BUILD
"""

import doctest
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

# What is shown, and not run: texts, formats of files, and commands that install something.
SHOWN = {"text", "sh", "json", "fmb", "proof", "smt2", "cmake", "meson", "bibtex", "diff"}
PLAYED = {"console"}
FENCE = re.compile(r"^(`{3,})(\S*)\n(.*?)^\1\n", re.M | re.S)

root, build = (pathlib.Path(name).resolve() for name in sys.argv[1:])
sys.path.insert(0, str(build / "bindings/python"))


def examples(page):
    """The examples of a page, as one test; each knows its line."""
    text, parts, printed = page.read_text(), [], None
    for _, language, code in FENCE.findall(text):
        if printed is not None and (language != "text" or printed != code):
            sys.exit(f"{page}: a program in C prints {printed!r}, not {code!r}")
        printed = None
        if language == "python":
            parts.append(code if ">>>" in code else "".join(
                f"{'...' if line[:1] in (' ', ')', ']', '}') else '>>>'} {line}\n" for line in code.splitlines() if line))
        elif language == "c":
            printed = run_c(code, page)
        elif language not in SHOWN | PLAYED and not language.startswith("{"):
            sys.exit(f"{page}: blocks of {language or 'no language'} are not known here")
    return doctest.DocTestParser().get_doctest("\n".join(parts), {}, str(page.relative_to(root)), str(page), 0)


def run_c(code, page):
    """Compile a program against the library of the build, and run it; what it prints."""
    with tempfile.TemporaryDirectory() as name:
        source, program = pathlib.Path(name, "program.c"), pathlib.Path(name, "program")
        source.write_text(code)
        flags = ["-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-I", root / "include"]
        for command in (["gcc", *flags, source, "-o", program, "-L", build / "lib", "-lfmb", "-lgmp"], [program]):
            done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "LD_LIBRARY_PATH": str(build / "lib")})
            if done.returncode:
                sys.exit(f"{page}: a program in C ended with {done.returncode}: {done.stderr}")
    return done.stdout


def run(test, page):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name, "here")
        shutil.copytree(root / "docs/examples", folder)
        shutil.copytree(page.parent, folder, dirs_exist_ok=True)
        os.chdir(folder)
        runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
        runner.run(test)
        os.chdir(root)
        return runner.summarize(verbose=False)


def main():
    os.environ["MPLBACKEND"] = "Agg"
    failed = asked = 0
    for page in sorted((root / "docs/site").rglob("*.md")):
        test = examples(page)
        if test.examples:
            result = run(test, page)
            failed, asked = failed + result.failed, asked + result.attempted
    print(f"{asked} examples, {failed} failed")
    sys.exit(bool(failed) or not asked)


if __name__ == "__main__":
    main()
