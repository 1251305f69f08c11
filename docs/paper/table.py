"""One list of a report of fmb-qualify (--json) as CSV, with the machine in each line.
usage: table.py LIST < REPORT.json > TABLE.csv"""

import csv
import json
import sys


def flatten(value, name=""):
    """What stands in objects and lists within each other, with names like a.b.0."""
    if isinstance(value, (dict, list)):
        pairs = value.items() if isinstance(value, dict) else enumerate(value)
        return {key: x for k, part in pairs for key, x in flatten(part, f"{name}.{k}" if name else str(k)).items()}
    return {name: value}


def main(which):
    report = json.load(sys.stdin)
    facts = {"commit": report["commit"], "cpu": report["machine"]["cpu"], "compiler": report["machine"]["compiler"],
             "load": f'{report["machine"]["load"]:.1f}', "passes": report.get("passes", "")}
    lines = [{**flatten(line), **facts} for line in report[which]]
    writer = csv.DictWriter(sys.stdout, list(dict.fromkeys(key for line in lines for key in line)), lineterminator="\n")
    writer.writeheader()
    writer.writerows({key: f"{x:.6g}" if isinstance(x, float) else x for key, x in line.items()} for line in lines)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
