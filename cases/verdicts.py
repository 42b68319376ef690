# SPDX-License-Identifier: GPL-3.0-or-later
"""Every case and variant in one table of verdicts: called by  cases/run --all [--short] [--threads N]"""
import json
import pathlib
import subprocess
import sys

CASES = pathlib.Path(__file__).resolve().parent


def runs(short):
    """(name, options) of everything that has an expectation: a case, then its variants."""
    for case in sorted(path.parent for path in CASES.glob("*/case.toml")):
        variants = sorted(path.stem for path in case.glob("*.toml")
                          if path.stem not in ("case", "short") and not path.stem.startswith("expected") and not path.stem.endswith("_short"))
        for variant in [None, *variants]:
            stem = "_".join(word for word in ("expected", variant, "short" if short else None) if word)
            if not (case / f"{stem}.toml").exists():
                continue
            options = ["--variant", variant] if variant else []
            yield case.name + (f" {variant}" if variant else ""), case, options + (["--short"] if short else [])


def shown(value):
    return "-" if value is None else f"{value:.5g}"


def percent(value):
    return "-" if value is None else f"{100 * value:+.2f} %"


BOUNDS = {"mean": "<= ", "maximum": "<= ", "minimum": ">= "}


def rows(name, directory):
    summary = json.loads((directory / "summary.json").read_text())
    for q in summary["quantities"]:
        yield (name, q["name"], q["measure"], BOUNDS.get(q["measure"], "") + shown(q["expected"]), shown(q["obtained"]), q["unit"], percent(q["relative_error"]),
               percent(q["tolerance"]).lstrip("+"), "pass" if q["pass"] else "FAIL")


def main():
    coupler, home, *rest = sys.argv[1:]
    short = "--short" in rest
    options = [word for word in rest if word != "--short"]
    table = [("case", "quantity", "measure", "expected", "obtained", "unit", "error", "tolerance", "result")]
    failed = []
    for name, case, form in runs(short):
        directory = pathlib.Path(home) / (name.replace(" ", "_") + ("_short" if short else ""))
        print(f"running {name}", file=sys.stderr, flush=True)
        code = subprocess.run([coupler, "run", case, *form, "--out", directory, *options],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False).returncode
        if (directory / "summary.json").exists():
            table += rows(name, directory)
        else:
            table.append((name, "-", "-", "-", "-", "-", "-", "-", f"exit {code}"))
        if code:
            failed.append(name)
    widths = [max(len(row[k]) for row in table) for k in range(len(table[0]))]
    for row in table:
        print("  ".join(text.ljust(width) if k in (0, 1, 2, 5) else text.rjust(width)
                        for k, (text, width) in enumerate(zip(row, widths))).rstrip())
    judged = {row[0] for row in table[1:]}
    print(f"verdict: {'fail' if failed else 'pass'} ({len(judged) - len(failed)} of {len(judged)} cases)"
          + (f"; failed: {', '.join(failed)}" if failed else ""))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
