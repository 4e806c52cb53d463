#!/usr/bin/env python3
"""Puts what `carrel bench stability --json` printed into docs/stability-table.md, between its markers.

    build/carrel bench stability --json > out/stability.json
    tools/stability_tables.py < out/stability.json
"""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/stability-table.md"
SILENT = {"pass-throughs", "not-finite-nodes", "step-over-bound"}  # asked of nearly every scene


def figure(row, name):
    unit = "" if row["unit"] in ("count", "share", "ratio") else f" {row['unit']}"
    text = f"{name} {row['value']:.3g}".strip() + unit
    if row["bound"] is None:
        return text
    text += f" {'≤' if (row['value'] <= row['bound']) == row['pass'] else '≥'} {row['bound']:g}"
    return text if row["pass"] else f"**{text}**"


def scene_lines(rows):
    for file in sorted((ROOT / "tests/hard_cases").glob("*.json")):
        scene = json.loads(file.read_text())
        conditions = {"-" + "-".join(filter(None, (c["is"], c.get("event")))).replace("_", "-") for c in scene["expect"]}
        figures = []
        for row in rows:
            suffix = re.sub(r"-\d+$", "", row["id"].removeprefix(file.stem))
            of_model = " (elastic)" if suffix.endswith("-elastic") else ""
            suffix = suffix.removesuffix("-elastic")
            if not row["id"].startswith(file.stem + "-") or suffix not in conditions:
                continue
            row["is_scene"] = True
            if suffix[1:] not in SILENT or not row["pass"]:
                figures.append(figure(row, suffix[1:].replace("-", "_") + of_model))
        yield f"| {file.stem} | {' '.join(scene['case'])} | {'; '.join(figures)} |"


def fill(page, name, lines):
    marks = re.compile(rf"(<!-- {name} -->\n).*?(<!-- end -->)", re.S)
    return marks.sub(lambda found: found[1] + "\n".join(lines) + "\n" + found[2], page)


def main():
    answer = json.load(sys.stdin)
    rows = answer["rows"]
    page = PAGE.read_text()
    page = fill(page, "scenes", ["| scene | cases | measured |", "|---|---|---|", *scene_lines(rows)])
    laws = [f"| {row['id']} | {row['what']} | {figure(row, '')} |" for row in rows if "is_scene" not in row]
    page = fill(page, "laws", ["| row | what | measured |", "|---|---|---|", *laws])
    missed = [row["id"] for row in rows if not row["pass"]]
    page = fill(page, "count", [f"{len(rows)} figures, {len(missed)} missed, on {answer['machine']}; {answer['build']}."])
    PAGE.write_text(page)


main()
