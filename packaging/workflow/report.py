#!/usr/bin/env python3
"""report.py FOLDER VERSION TREE...: makes report.html and summary.csv of FOLDER from what came of each tree.
Both depend on the trees alone, not on when or in which order they were reconstructed."""

import base64
import csv
import html
import json
import os
import statistics
import sys
from pathlib import Path
from urllib.parse import quote

OF_A_RUN = ("seconds", "inputs")  # left out: they differ from run to run
WORDS = ("name", "status", "problem")
STYLE = """body { font: 15px/1.45 sans-serif; margin: 2em auto; max-width: 70em; color: #23262a; }
table { border-collapse: collapse; } th, td { text-align: right; padding: 4px 10px; vertical-align: middle; }
th { border-bottom: 1px solid #8d968e; } td { border-bottom: 1px solid #e4e8e4; }
.text { text-align: left; } .failed td { background: #fdf0e9; } img { width: 80px; height: 80px; display: block; }
small { color: #5b625c; }"""


def result_of(folder, tree):
    file = folder / "trees" / tree / "result.json"
    if not file.exists():
        return {"row": {"name": tree, "status": "missing",
                        "problem": "its job ended without a result: start again to do it"}, "notes": []}
    return json.loads(file.read_text())


def number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def safe(cell):
    """Text that no spreadsheet computes, as in all tables of espalier."""
    return "'" + cell if cell[:1] in ("=", "+", "-", "@") and number(cell) is None else cell


def write(file, text):
    part = file.with_name(file.name + ".part")
    part.write_text(text, newline="")
    os.replace(part, file)


def summary(columns, rows):
    lines = []
    writer = csv.writer(type("Lines", (), {"write": lambda self, line: lines.append(line)})(),
                        lineterminator="\n")
    writer.writerow(columns)
    for row in rows:
        writer.writerow([safe(row.get(column) or "") for column in columns])
    return "".join(lines)


def picture(folder, tree):
    file = folder / "trees" / tree / "picture.png"
    if not file.exists():
        return ""
    return f'<img alt="" src="data:image/png;base64,{base64.b64encode(file.read_bytes()).decode()}">'


def line(folder, result, columns):
    row, name = result["row"], result["row"]["name"]
    cells = [f"<td>{picture(folder, name)}</td>"]
    for column in columns:
        text = html.escape(row.get(column) or "")
        if column == "name" and row["status"] == "done":
            text = f'<a href="{quote(f"trees/{name}/{name}.mtg")}">{text}</a>'
        elif column == "name":
            text = f'<a href="{quote(f"trees/{name}/log.txt")}">{text}</a>'
        if column == "problem":
            text += "".join(f"<br><small>{html.escape(note)}</small>" for note in result["notes"])
        cells.append(f'<td{" class=text" if column in WORDS else ""}>{text}</td>')
    return f'<tr{"" if row["status"] == "done" else " class=failed"}>{"".join(cells)}</tr>'


def medians(columns, rows):
    cells = ["<td></td>"]
    for column in columns:
        values = [v for v in (number(row.get(column)) for row in rows) if v is not None]
        text = f"{statistics.median(values):.6g}" if values and column not in WORDS else ""
        cells.append(f'<td>{"median" if column == "name" else text}</td>')
    return f'<tr>{"".join(cells)}</tr>'


def page(folder, version, results, columns):
    rows = [result["row"] for result in results]
    failed = [row for row in rows if row["status"] != "done"]
    said = f"{len(rows) - len(failed)} of {len(rows)} trees are reconstructed."
    if failed:
        said += " The others are marked: the table says why, and their names lead to what was reported."
    heads = "".join(f'<th{" class=text" if c in WORDS else ""}>{html.escape(c.replace("_", " "))}</th>'
                    for c in columns)
    body = "\n".join(line(folder, result, columns) for result in results)
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Trees</title><style>{STYLE}</style></head>
<body><h1>{len(rows)} trees</h1><p>{said} Lengths are in the unit of the scans.
Made by {html.escape(version)}.</p>
<table><tr><th></th>{heads}</tr>
{medians(columns, rows)}
{body}
</table></body></html>
"""


def main():
    folder, version, trees = Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
    results = [result_of(folder, tree) for tree in sorted(trees)]
    rows = [result["row"] for result in results]
    longest = max(rows, key=len)
    columns = ["name", "status"]
    columns += [c for c in longest if c not in columns and c not in OF_A_RUN and c != "problem"]
    columns.append("problem")
    write(folder / "summary.csv", summary(columns, rows))
    write(folder / "report.html", page(folder, version, results, columns))
    for row in rows:
        if row["status"] != "done":
            print(f"{row['name']}: {row['problem']}", file=sys.stderr)


main()
