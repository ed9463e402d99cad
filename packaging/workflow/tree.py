#!/usr/bin/env python3
"""One tree of the workflow: runs `espalier batch` on a table of this one plant, draws it, and writes
what came of it, as result.json. Ends with an error only where another attempt may do better."""

import argparse
import csv
import json
import os
import signal
import subprocess
import sys
from pathlib import Path

NO_MEMORY = "not enough memory"


def run(command, log):
    """Its exit status, below 0 where a signal ended it, and what it wrote on standard error."""
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                          errors="replace", check=False)
    log.write(done.stderr)
    return done.returncode, done.stderr


def flags_of(settings):
    """The flags of `espalier batch` that these settings of the workflow are."""
    flags = ["--up", str(settings["up"])]
    for flag in ("preset", "unit"):
        if settings[flag]:
            flags += ["--" + flag, str(settings[flag])]
    for each in settings["set"]:
        flags += ["--set", str(each)]
    return flags + [str(each) for each in settings["options"]]


def reconstruct(arguments, folder, log):
    """The line of the summary for this tree, and notes."""
    table = folder / "table.csv"
    with table.open("w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["name", "scan", "reference"])
        rows.writerow([arguments.name, arguments.scan.resolve(),
                       Path(arguments.reference).resolve() if arguments.reference else ""])
    command = [arguments.espalier, "batch", str(table), "-o", str(folder),
               "--threads", str(arguments.threads)] + flags_of(json.loads(arguments.settings))
    # What a run before made, or failed at, is none of this.
    for made in ("summary.csv", "picture.png", arguments.name + ".mtg", arguments.name + ".doubts.json"):
        (folder / made).unlink(missing_ok=True)
    status, errors = run(command, log)
    if status == -signal.SIGINT or status == 130:
        sys.exit(130)
    row = {}
    if (folder / "summary.csv").exists():
        with (folder / "summary.csv").open(newline="") as file:
            row = next(csv.DictReader(file), {})
    prefix = f"espalier: {arguments.name}: "
    notes = [line[len(prefix):] for line in errors.splitlines() if line.startswith(prefix)]
    if not row:
        said = [line.removeprefix("espalier: ") for line in errors.splitlines() if line]
        ended = f"espalier was killed by signal {-status}" if status < 0 else "espalier failed"
        row = {"status": "failed", "problem": ": ".join([ended] + said[-1:])}
    if row["status"] == "failed":
        notes = []
        if status < 0 or NO_MEMORY in row["problem"]:
            row["problem"] += f" (attempt {arguments.attempt} of {arguments.last})"
            if arguments.attempt < arguments.last:
                print(f"{arguments.name}: {row['problem']}", file=sys.stderr)
                sys.exit(1)
    if arguments.no_reference_in:
        notes.append(f"no scores: {arguments.no_reference_in} holds no structure named as the scan")
    return row, notes


def draw(arguments, folder, log):
    command = [arguments.espalier, "picture", str(arguments.scan),
               str(folder / (arguments.name + ".mtg")), "-o", str(folder / "picture.png"),
               "--bare", "--width", "240", "--height", "240"]
    run(command, log)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--name", required=True)
    parser.add_argument("--scan", required=True, type=Path)
    parser.add_argument("--reference", required=True, help="empty: there is none")
    parser.add_argument("--no-reference-in", required=True, help="where it is missing; empty: nowhere")
    parser.add_argument("--settings", required=True)
    parser.add_argument("--threads", required=True, type=int)
    parser.add_argument("--attempt", required=True, type=int)
    parser.add_argument("--last", required=True, type=int)
    parser.add_argument("--espalier", required=True)
    parser.add_argument("--result", required=True, type=Path)
    arguments = parser.parse_args()

    folder = arguments.result.parent
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "log.txt").open("w") as log:
        row, notes = reconstruct(arguments, folder, log)
        if row["status"] == "done":
            draw(arguments, folder, log)
    row["name"] = arguments.name
    part = arguments.result.with_suffix(".part")
    part.write_text(json.dumps({"row": row, "notes": notes}, indent=1) + "\n")
    os.replace(part, arguments.result)


if __name__ == "__main__":
    main()
