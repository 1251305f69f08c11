"""Every public function, class, method and property of the Python package stands in an example that is run: of
a docstring, of its README, or of a page of the site; and its reference names every function and class.
usage: python_examples.py ROOT BUILD"""

import ast
import doctest
import inspect
import pathlib
import re
import sys

root, build = (pathlib.Path(name).resolve() for name in sys.argv[1:])
sys.path.insert(0, str(build / "bindings/python"))

FENCE = re.compile(r"^```python\n(.*?)^```\n", re.M | re.S)


def texts():
    """Whatever holds examples."""
    for path in sorted((root / "bindings/python/fmb").glob("*.py")):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)):
                yield path, ast.get_docstring(node) or ""
    for path in [root / "bindings/python/README.md", *sorted((root / "docs/site").rglob("*.md"))]:
        yield path, "\n".join(FENCE.findall(path.read_text()))


def used():
    """Names and attributes in examples."""
    out = set()
    for path, text in texts():
        for example in doctest.DocTestParser().get_examples(text, str(path)):
            for node in ast.walk(ast.parse(example.source)):
                if isinstance(node, ast.Name):
                    out.add(node.id)
                elif isinstance(node, ast.Attribute):
                    out.add(node.attr)
    return out


def public():
    """(qualified name, name) of what the package offers. What an exception says is not asked for."""
    import fmb
    import fmb.bridges
    import fmb.lab
    for module, names in ((fmb, dir(fmb)), (fmb.bridges, vars(fmb.bridges)), (fmb.lab, fmb.lab.__all__)):
        for name in names:
            what = getattr(module, name)
            home = getattr(what, "__module__", "")
            if name.startswith("_") or name == "text" or not home.startswith("fmb") or (
                    module is fmb.bridges and home != "fmb.bridges"):
                continue  # `text` is what the package uses itself
            yield f"{module.__name__}.{name}", name
            if inspect.isclass(what) and not issubclass(what, Exception):
                for member, value in vars(what).items():
                    if not member.startswith("_") and (callable(value) or isinstance(
                            value, (property, classmethod, staticmethod))):
                        yield f"{module.__name__}.{name}.{member}", member


# Types of answers and of rows have no constructor to call: what they are is shown by what gives them.
GIVEN = {"Answer", "Box", "Conflict", "End", "Event", "Frame", "Generators", "Hits", "Interval", "Judgement", "Optimum",
         "Pairs", "Point", "Proximity", "Reduction", "Row", "Rule", "SystemAnswer", "SystemRow", "Form", "Variable",
         "LinprogResult", "Trial", "View", "ViewRow", "Wrong"}


def main():
    known = used()
    names = sorted(set(public()))
    missing = [full for full, name in names if name not in known | GIVEN]
    page = (root / "docs/site/reference/python.md").read_text()
    listed = set(re.findall(r"^\.\. auto(?:function|class|exception):: (\w+)", page, re.M))
    faults = [f"{name}: no example" for name in missing]
    faults += [f"{full}: not in the reference" for full, name in names
               if full in (f"fmb.{name}", f"fmb.bridges.{name}", f"fmb.lab.{name}") and name not in listed]
    print("\n".join(faults) or f"{len(names)} public names, all in examples and in the reference")
    sys.exit(bool(faults) or len(names) < 80)


if __name__ == "__main__":
    main()
