# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every case and every variant of it, one after the other, and prints one table of verdicts.

run_all.py COUPLER [--short] [options of coupler run]     exit code 0 only if everything expected was obtained
"""
import json
import pathlib
import subprocess
import sys

CASES = pathlib.Path(__file__).resolve().parent
HEADER = ("case", "quantity", "measure", "expected", "obtained", "unit", "error", "tolerance", "result")


def forms(short):
    """Every (case folder, variants) that has an expectation; in the short form where there is one."""
    for file in sorted(CASES.glob("*/case.toml")):
        names = [path.stem for path in sorted(file.parent.glob("*.toml"))]
        variants = [name for name in names if name not in ("case", "short") and not name.startswith("expected")]
        for variant in [[]] + [[name] for name in variants]:
            choices = ([variant + ["short"]] if short else []) + [variant]
            judged = [choice for choice in choices if "_".join(["expected", *choice]) in names]
            if judged:
                yield file.parent, judged[0]


def run(coupler, folder, variants, options):
    """Summary of the run; empty if it left none."""
    words = [word for variant in variants for word in ("--variant", variant)]
    process = subprocess.run([coupler, "run", folder, *words, *options, "--json"], text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE)
    try:
        return json.loads(process.stdout), process
    except json.JSONDecodeError:
        return {}, process


def number(value):
    return "-" if value is None else f"{value:.5g}"


def percent(value, sign=""):
    return "-" if value is None else f"{100 * value:{sign}.4g} %"


def row(name, quantity):
    bound = {"minimum": ">= ", "maximum": "<= ", "mean": "<= "}.get(quantity["measure"], "")
    result = "pass" if quantity["pass"] else "FAIL" + (": " + quantity["remark"] if "remark" in quantity else "")
    return (name, quantity["name"], quantity["measure"], bound + number(quantity["expected"]),
            number(quantity["obtained"]), "-" if quantity["unit"] == "1" else quantity["unit"],
            percent(quantity["relative_error"], "+"), percent(quantity["tolerance"]), result)


def main():
    coupler, options = sys.argv[1], sys.argv[2:]
    short = "--short" in options
    options = [option for option in options if option != "--short"]
    rows, broken = [], 0
    for folder, variants in forms(short):
        name = " ".join([folder.name, *variants])
        print(f"{name} ...", file=sys.stderr, end=" ", flush=True)
        summary, process = run(coupler, folder, variants, options)
        quantities = summary.get("quantities", [])
        verdict = summary.get("verdict", "fail")
        print(verdict, file=sys.stderr, flush=True)
        if process.returncode not in (0, 1) or not quantities:
            lines = process.stderr.strip().splitlines()
            rows.append((name, *["-"] * 7, "FAIL: " + (lines[-1] if lines else "nothing was expected")))
            broken += 1
        rows += [row(name, quantity) for quantity in quantities]
    widths = [max(len(line[column]) for line in [HEADER, *rows]) for column in range(len(HEADER) - 1)]
    for line in [HEADER, *rows]:
        print("  ".join([cell.ljust(width) for cell, width in zip(line, widths)] + [line[-1]]))
    missed = sum(line[-1] != "pass" for line in rows)
    print(f"{len(rows) - missed} of {len(rows)} quantities pass" + (f"; {broken} runs broke down" if broken else ""))
    return 1 if missed or not rows else 0


if __name__ == "__main__":
    sys.exit(main())
