#!/usr/bin/env python3
"""What a person at the window waits for: first frames, pace, frames a second, and how late the picture is. Prints a row
a figure, tabs between: id, value, unit, bound ("" where there is none), what it is. To be run under xvfb-run, on a
machine that does nothing else; `carrel bench window` does that.

    measure.py PROGRAM FOLDER-OF-DRILLS [--quick]
"""
import pathlib
import signal
import sqlite3
import statistics
import sys
import time

from desk import Desk, Server, xdo

PROGRAM, DRILLS = sys.argv[1], pathlib.Path(sys.argv[2])
QUICK = "--quick" in sys.argv
TITLE = "Square knot around a 4 mm vessel"


def row(name, value, unit, bound, what):
    print(name, f"{value:.4g}", unit, bound, what, sep="\t", flush=True)


def share(values, part):
    return sorted(values)[min(len(values) - 1, int(part * len(values)))]


def scenes(desk):
    """How many frames were drawn so far."""
    return desk.scene.read_bytes().count(b"\n")


def first_frame():
    began = time.monotonic()
    with Desk(PROGRAM, str(DRILLS / "square-knot.json")) as desk:
        desk.screen("play", 60)
        row("first-frame-s", time.monotonic() - began, "s", 2, "from the command to the first frame of a drill")


def menu_of_a_thousand():
    """A menu whose player has a thousand recordings of one drill, of some seconds each."""
    count = 20 if QUICK else 1000
    with Desk(PROGRAM, str(DRILLS / "square-knot.json"), settings={"who": "resident7"}) as desk:
        desk.play(60)
        desk.wait(lambda ui: float(ui["says"]["time"]) > 2, "two seconds", 60)
        desk.end()
        original = desk.recordings()[0]
        for i in range(count - 1):
            original.with_name(f"copy-{i}.carrel").write_bytes(original.read_bytes())
        began = time.monotonic()
        desk.start(PROGRAM)
        desk.screen("menu", 60)
        row("menu-first-frame-s", time.monotonic() - began, "s", 2, f"to the menu, {count} recordings")
        desk.wait(lambda ui: str(count) in ui["says"].get(f"tries {TITLE}", ""), "all tries", 60)
        row("menu-history-s", time.monotonic() - began, "s", 2, f"until all {count} recordings are counted")


def moves_of(desk, server, end):
    """The right hand goes to and fro, and the left as well, until then; the paces that the screen said meanwhile."""
    side, shown = 1, []
    while time.monotonic() < end:
        server.send("key", "A" if side > 0 else "D", 1)
        for _ in range(60):
            server.send("move", 2 * side, 0)
            time.sleep(0.008)
        server.send("key", "A" if side > 0 else "D", 0)
        side = -side
        shown.append(float(desk.says("pace")))
    return shown


def paced(drill, name, inset, bounds):
    """A drill while both hands move: its pace, frames, and what its recording says of both."""
    seconds = 5 if QUICK else 60
    with Desk(PROGRAM, str(DRILLS / f"{drill}.json")) as desk:
        server = Server()
        desk.play(60)
        if not inset:
            xdo("key", "p")
        time.sleep(2)
        began, t_s, frames = time.monotonic(), float(desk.says("time")), scenes(desk)
        shown = statistics.mean(moves_of(desk, server, began + seconds))
        wall_s = time.monotonic() - began
        rate = (float(desk.says("time")) - t_s) / wall_s
        frames = (scenes(desk) - frames) / wall_s
        desk.end()
        rows = sqlite3.connect(desk.recordings()[0]).execute(
            "SELECT rate, dropped_ms, used_p50_ms, used_p99_ms, shown_p50_ms, shown_p99_ms FROM pace").fetchall()[2:]
        row(f"pace-{name}", rate, "ratio", bounds.get("pace", ""), f"{name}: simulated over wall time, {seconds} s")
        row(f"frames-{name}", frames, "1/s", bounds.get("frames", ""), f"{name}: frames drawn")
        row(f"dropped-{name}-ms", sum(r[1] for r in rows), "ms", "", f"{name}: wall time given up")
        row(f"pace-shown-{name}", abs(shown / rate - 1), "share", 0.02, f"{name}: mean pace shown against the true one")
        for at, what in ((2, "used-p50"), (3, "used-p99"), (4, "shown-p50"), (5, "shown-p99")):
            values = [r[at] for r in rows if r[at] is not None]
            if values:
                row(f"{what}-{name}-ms", statistics.median(values), "ms", "", f"{name}: event to {what[:-4]}, median of seconds")


def moved(desk, server, side, wait_s):
    """A move of the mouse: how long until a pixel beside the tip of the right instrument changes [ms]; None: never."""
    ui = desk.wait(lambda ui: ui["says"].get("tip right"), "where the tip is")
    x, y = map(int, ui["says"]["tip right"].split())
    place = (x - 40, y - 40, 80, 80)
    time.sleep(wait_s)
    before = server.pixels(*place)
    began = time.monotonic()
    server.send("move", 12 * side, 0)
    while time.monotonic() < began + 1:
        if server.pixels(*place) != before:
            return 1e3 * (time.monotonic() - began)
        time.sleep(0.001)
    return None


def latency():
    """From an X event to the pixel that it changes; in parts, for the drill ends after two minutes."""
    moves, part, took, inside, server = 20 if QUICK else 500, 100, [], [], Server()
    while len(took) < moves:
        with Desk(PROGRAM, str(DRILLS / "square-knot.json")) as desk:
            desk.play(60)
            for key in ("k", "h"):  # what moves by itself
                xdo("key", key)
            time.sleep(1)
            count = min(part, moves - len(took))
            took += [moved(desk, server, 1 if i % 2 else -1, 0.15 + 0.0007 * (i % 50)) for i in range(count)]
            desk.end()
            inside += [r[0] for r in sqlite3.connect(desk.recordings()[0]).execute(
                "SELECT shown_p50_ms FROM pace WHERE shown_p50_ms IS NOT NULL")]
    seen = [ms for ms in took if ms is not None]
    row("pixel-p50-ms", share(seen, 0.5), "ms", 70, f"X event to pixel, {len(seen)} moves")
    row("pixel-p99-ms", share(seen, 0.99), "ms", 130, "the same, 99 of 100")
    row("pixel-missed", len(took) - len(seen), "count", 0, "moves that changed no pixel within a second")
    row("pixel-later-ms", share(seen, 0.5) - statistics.median(inside), "ms", 15,
        "how much later that is than what the window itself measures, at the median")


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    first_frame()
    menu_of_a_thousand()
    paced("square-knot", "square-knot", False, {"pace": 0.98, "frames": 24})
    paced("square-knot", "square-knot-two-cameras", True, {"pace": 0.98, "frames": 15})
    paced("interrupted-stitch", "interrupted-stitch", True, {})
    latency()
