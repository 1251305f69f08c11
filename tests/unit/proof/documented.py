"""documented.py FMB DOCUMENT: the proofs in the document are right, and so is the small checker.

Every block ```proof is about the block ```fmb before it. Both judges, `fmb check` and check_proof.py, must
accept it; then its numbers are changed, one by one, and the judges must agree on each change. The judge is as
short as the document says.
"""
import os
import re
import subprocess
import sys
import tempfile

import check_proof

KINDS = ["feasible", "infeasible", "bound", "unbounded", "implied", "redundant", "equality",
         "irredundant", "corner", "whole", "follows"]


def blocks(path):
    """(system, proof) for each proof in the document."""
    system = None
    for kind, text in re.findall(r"^```(fmb|proof)\n(.*?)^```$", open(path).read(), re.M | re.S):
        if kind == "fmb":
            system = text
        else:
            yield system, text


def changes(proof):
    """The proof with one number or sign of a claim changed."""
    for m in re.finditer(r"(?<![\w-])-?\d+(/\d+)?(?![\w/])|>=|<=|[<>]", proof):
        if not proof.index("claim") < m.start() < proof.index("claims "):
            continue
        word = m.group()
        for other in ["0", "1", "2", "-1", "1/2", "3"] if word[-1].isdigit() else ["<", "<=", ">="]:
            yield proof[:m.start()] + other + proof[m.end():]


class Judges:
    def __init__(self, fmb, folder, system):
        self.fmb, self.folder = fmb, folder
        self.system = self.write("system.fmb", system)
        text = subprocess.run([fmb, "convert", self.system, "--to", "ine"], check=True,
                              stdout=subprocess.PIPE, text=True).stdout
        self.ine = self.write("system.ine", text)

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w") as out:
            out.write(text)
        return path

    def ask(self, proof):
        """The answers of fmb check and of check_proof.py; None if it is malformed."""
        path = self.write("proof", proof)
        code = subprocess.run([self.fmb, "check", self.system, path], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE).returncode
        if code == 65:
            return None
        assert code in (0, 1), f"exit {code} on\n{proof}"
        return code == 0, check_proof.judge(*check_proof.read(self.ine, path)) == "accepted"


def check_lines(document):
    """The judge, by the files that the document names, has so many lines at most, and not far fewer."""
    names, most = re.search(r"The judge \((.*?) in `lib/proof`.*?fewer than ([\d,]+) lines",
                            open(document).read(), re.S).groups()
    folder, most = os.path.join(os.path.dirname(document), "../lib/proof"), int(most.replace(",", ""))
    paths = [os.path.join(folder, name + end) for name in re.findall(r"`([\w/]+)`", names)
             for end in (".c", ".h")]
    lines = sum(len(open(path).readlines()) for path in paths if os.path.exists(path))
    assert most - 200 < lines < most, f"the judge has {lines} lines, not fewer than {most}"


def main(fmb, document):
    check_lines(document)
    seen, asked, rejected = set(), 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for system, proof in blocks(document):
            judges = Judges(fmb, folder, system)
            assert judges.ask(proof) == (True, True), f"not accepted:\n{system}\n{proof}"
            seen.update(re.findall(r"^claim (\w+)", proof, re.M))
            for changed in changes(proof):
                answers = judges.ask(changed)
                if answers:
                    assert answers[0] == answers[1], f"{answers}\n{system}\n{changed}"
                    asked, rejected = asked + 1, rejected + (not answers[0])
    assert seen == set(KINDS), f"no example of {set(KINDS) - seen}"
    assert asked > 150 and rejected > asked / 2, (asked, rejected)
    print(f"{asked} changed proofs, {rejected} rejected, by both judges")


if __name__ == "__main__":
    main(*sys.argv[1:])
