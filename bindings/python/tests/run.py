"""run.py: every example in the package, and every test beside this file: run.py [PACKAGE]."""

import contextlib
import doctest
import importlib
import io
import pathlib
import re
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent


def loaded(name):
    """A module of the package; None where it needs NumPy, which is not there."""
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as e:
        print(f"{name}: left out, {e}")
        return None


def examples(package):
    """Examples of all modules; in each, the names of all are known."""
    stems = sorted(path.stem for path in pathlib.Path(package).glob("*.py"))
    names = ["fmb" if stem == "__init__" else f"fmb.{stem}" for stem in stems]
    modules = [module for module in map(loaded, names) if module]
    known = {}
    for module in modules:
        known.update(vars(module))
    failed = asked = 0
    for module in modules:
        result = doctest.testmod(module, extraglobs={**known, **vars(module)})
        failed, asked = failed + result.failed, asked + result.attempted
    result = doctest.testfile(str(HERE.parent / "README.md"), module_relative=False)
    failed, asked = failed + result.failed, asked + result.attempted
    print(f"{asked} examples, {failed} failed")
    return failed == 0 and asked > 0


def program_of(page):
    """The one program in Python of a page, and what it prints."""
    text = (HERE.parents[2] / page).read_text(encoding="utf-8")
    (program,) = re.findall(r"^```python\n(.*?)^```", text, re.M | re.S)
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(program, {})  # pylint: disable=exec-used
    return program, out.getvalue(), text


def prints(page, printed, told):
    """Is it what the page says?"""
    if printed != told:
        print(f"{page}: {printed!r} is not {told!r}")
    return printed == told


def pages():
    """The programs in pages of the project print what these say: the README behind each line, the page
    about rules in its last block of text."""
    program, printed, _ = program_of("README.md")
    good = prints("README.md", printed.splitlines(),
                  [line.split("# ")[1] for line in program.splitlines() if "# " in line])
    _, printed, text = program_of("docs/adding-a-rule.md")
    told = re.findall(r"^```text\n(.*?)^```", text, re.M | re.S)[-1]
    return prints("docs/adding-a-rule.md", printed, told) and good


def main():
    package = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else HERE.parent / "fmb").resolve()
    sys.path[:0] = [str(package.parent), str(HERE)]
    good = examples(package) and pages()
    tests = unittest.defaultTestLoader.discover(str(HERE), pattern="test_*.py")
    result = unittest.TextTestRunner(verbosity=1).run(tests)
    sys.exit(0 if good and result.wasSuccessful() and result.testsRun > 0 else 1)


if __name__ == "__main__":
    main()
