#!/usr/bin/env python3
"""Puts what `carrel bench speed --json` printed into the tables of docs/speed.md: tools/speed_tables.py < speed.json"""
import json
import pathlib
import re
import sys

answer = json.load(sys.stdin)
rows = {row["id"]: row for row in answer["rows"]}
SCENES = [("pull-n200", "200 links, 0.1 m/s"), ("pull-n1000", "1000 links, 0.1 m/s"),
          ("pull-n200-fast", "200 links, 2 m/s")]
WHOSE = ["", "ode-", "bullet-"]
FIGURES = ["tick-p50", "tick-p99", "tick-max", "tight-p50", "tight-p99", "stretch-pull", "stretch-rest", "stretch-over",
           "gap-pull", "gap-over", "kappa-least", "lag", "knot-kept", "pass-throughs"]


def figure(value, unit):
    if value is None:
        return "no number"
    if unit == "%":
        return f"{value:.2g}" if value < 1 else f"{value:.1f}"
    return f"{value:.3g}" if abs(value) < 1000 else f"{value:.0f}"


def cell(row_id):
    row = rows.get(row_id)
    if row is None:
        return "–"
    text = figure(row["value"], row["unit"])
    if row["bound"] is None:
        return text
    asked = "=" if row["value"] == row["bound"] else "≤" if (row["value"] < row["bound"]) == row["pass"] else "≥"
    text = f"{text} ({asked} {row['bound']:g})"
    return text if row["pass"] else f"**{text}**"


def table(head, lines):
    return "\n".join("| " + " | ".join(line) + " |" for line in [head, ["---"] * len(head), *lines])


def pulls():
    head = ["figure"] + [words for _, words in SCENES]
    lines = []
    for name in FIGURES:
        unit = next(row["unit"] for row_id, row in rows.items() if row_id.endswith(name))
        lines.append([f"`{name}` [{unit}]"] +
                     [" / ".join(cell(f"{whose}{scene}-{name}") for whose in WHOSE) for scene, _ in SCENES])
    for name in ["tick-p99-over-p50", "ode-ratio", "bullet-ratio"]:
        lines.append([f"`{name}`"] + [cell(f"{scene}-{name}") for scene, _ in SCENES])
    return table(head, lines)


def growth():
    sizes = [100, 300, 1000, 3000, 10000]
    head = ["`growth-…` [us]"] + [f"`n{n}`" for n in sizes] + ["`exponent`"]
    return table(head, [[f"`{how}`"] + [cell(f"growth-{how}-n{n}") for n in sizes] + [cell(f"growth-{how}-exponent")]
                        for how in ["loose", "coiled"]])


def trade_off():
    head = ["`ftl-…`", "`cost` [ms per s]", "`stretch` [%]", "`gap` [D]", "`kappa` [D]"]
    settings = [row_id[:-len("-cost")] for row_id in rows if row_id.endswith("-cost")]
    return table(head, [[f"`{s[4:]}`"] + [cell(f"{s}-{name}") for name in ["cost", "stretch", "gap", "kappa"]]
                        for s in settings])


def links():
    figures = [("most", "links at most"), ("tick-p50", "`tick-p50` [us]"), ("tick-p99", "`tick-p99` [us]"),
               ("takes-up", "`takes-up` [D]"), ("stretch", "`stretch` [%]"), ("gap", "`gap` [D]"), ("knot-kept", "`knot-kept`"),
               ("pass-throughs", "`pass-throughs`"), ("moved", "`moved` [R]"), ("ratio", "`ratio`")]
    of = ["short", "long", "fitted"]
    return table(["`links-…`", *(f"`{name}`" for name in of)],
                 [[words, *(cell(f"links-{name}-{figure}") for name in of)] for figure, words in figures])


page = pathlib.Path(__file__).resolve().parent.parent / "docs" / "speed.md"
text = page.read_text()
for name, made in [("machine", answer["machine"] + "; " + answer["build"] + "."), ("pulls", pulls()), ("growth", growth()),
                   ("trade-off", trade_off()), ("links", links())]:
    text = re.sub(rf"(<!-- {name} -->\n).*?(<!-- end -->)", lambda m: m[1] + made + "\n" + m[2], text, flags=re.S)
page.write_text(text)
