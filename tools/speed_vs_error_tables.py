#!/usr/bin/env python3
"""Puts what `carrel bench speed-vs-error --json` printed into docs/speed-vs-error-table.md, between its markers.

    build/carrel bench speed-vs-error --json --plot docs/speed-vs-error > out/speed-vs-error.json
    tools/speed_vs_error_tables.py < out/speed-vs-error.json
"""
import json
import pathlib
import re
import sys

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs/speed-vs-error-table.md"
SETTING = re.compile(r"(.+)-(ftl|elastic|rod)-link(\d+)(?:-tick(\d+))?-(found|error|cost|links|sweeps)$")
DRILL = re.compile(r"drill-(.+)-([^-]+)-(same|knot|loop|shorter|longer|tension|cost|p50|p99)$")
WORDS = re.compile(r"(.+); .+, links \((.+)\) ([\d.]+)(?:, ticks of ([\d.]+) ms)?: ")


def short(value):
    if value is None:
        return "–"
    return f"{value:.2g}" if abs(value) < 99.5 else f"{value:.0f}"


def settings_of(rows):
    """Of every problem, thread and tick: what was measured with links so long."""
    problems = {}
    for row in rows:
        if DRILL.match(row["id"]):
            continue
        problem, thread, _, _, figure = SETTING.match(row["id"]).groups()
        what, counts, link, tick = WORDS.match(row["what"]).groups()
        of = problems.setdefault(problem, {"what": what, "counts": counts, "by": {}})
        of["by"].setdefault((thread, tick), {}).setdefault(link, {})[figure] = row["value"]
    return problems


def cell(measured):
    error = f"{short(measured['error'])} %" if "error" in measured else f"{measured['found']:.3g}"
    links = f", {measured['links']:.0f} links" if "links" in measured else ""
    return f"{error}, {short(measured['cost'])} ms{links}"


def lines(problem, of):
    links = list(dict.fromkeys(link for by_link in of["by"].values() for link in by_link))
    yield f"**{of['what'][0].upper() + of['what'][1:]}.** Columns: links, {of['counts']}."
    yield ""
    yield "| thread | tick [ms] | " + " | ".join(links) + " |"
    yield "|---|---|" + "---|" * len(links)
    for (thread, tick), by_link in of["by"].items():
        yield f"| {thread} | {tick or '–'} | " + " | ".join(cell(by_link[link]) if link in by_link else "–" for link in links) + " |"
    yield ""
    yield f"![{of['what']}](speed-vs-error/{problem}.svg)"
    yield ""


def drills_of(rows):
    """Of every drill and way to play it: its rows by figure. None of a quick run, which has nothing fine to hold them against."""
    drills = {}
    for row in rows:
        if found := DRILL.match(row["id"]):
            drill, way, figure = found.groups()
            drills.setdefault(drill, {}).setdefault(way, {})[figure] = row
    return {drill: ways for drill, ways in drills.items() if "same" in next(iter(ways.values()))}


def drill_cell(row):
    off = "" if row["error"] is None or row["id"].split("-")[-2] == "fine" else f" ({short(row['error'])})"
    return f"{row['value']:.3g}{off}"


def drill_lines(ways):
    drill = next(iter(ways.values()))["same"]["what"].split("; ")[0]
    yield f"**`{drill}`.**"
    yield ""
    yield "| played with | knot | in the knot [mm] | loop [mm] | tails [mm] | largest tension [N] | cost [ms] | tick, median and p99 [us] |"
    yield "|---|---|---|---|---|---|---|---|"
    for of in ways.values():
        way, knot = of["same"]["what"].split("; ", 1)[1].removesuffix(", as in the fine run").split(": ", 1)
        knot = knot if of["same"]["value"] else f"**{knot}**"
        cells = [drill_cell(of[figure]) for figure in ("knot", "loop", "shorter", "longer", "tension")]
        ticks = f"{of['p50']['value']:.0f}, {of['p99']['value']:.0f}"
        yield f"| {way} | {knot} | {cells[0]} | {cells[1]} | {cells[2]}, {cells[3]} | {cells[4]} | {short(of['cost']['value'])} | {ticks} |"
    yield ""


def fill(page, name, made):
    marks = re.compile(rf"(<!-- {name} -->\n).*?(<!-- end -->)", re.S)
    return marks.sub(lambda found: found[1] + "\n".join(made) + "\n" + found[2], page)


def main():
    answer = json.load(sys.stdin)
    problems = settings_of(answer["rows"])
    page = PAGE.read_text()
    page = fill(page, "machine", [f"{answer['machine']}; {answer['build']}."])
    page = fill(page, "problems", [line for problem, of in problems.items() for line in lines(problem, of)][:-1])
    page = fill(page, "drills", [line for ways in drills_of(answer["rows"]).values() for line in drill_lines(ways)][:-1])
    PAGE.write_text(page)


main()
