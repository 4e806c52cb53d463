"""The window as people meet it: real X events, controls found by their labels. Run under xvfb-run.

    window_test.py PROGRAM SOURCE SUITE
"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

from desk import Desk, xdo

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
DRILLS = SOURCE / "scenarios/drills"
SQUARE = str(DRILLS / "square-knot.json")
TITLE = "Square knot around a 4 mm vessel"


def replayed(recording):
    """What a replay makes of a recording; fails unless every hash, event and score in it is met."""
    done = subprocess.run([PROGRAM, "replay", "--verify", "--json", str(recording)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def value_of(result, name):
    return float(next(item for item in result["items"] if item["name"] == name)["value"])


def play(desk):
    desk.screen("play")
    desk.click("Begin")
    desk.wait(lambda ui: ui["says"].get("paused") == "no", "ticks")


def tip(desk, tool):
    x, y = desk.says(f"tip {tool}").split()
    return int(x), int(y)


class Opens(unittest.TestCase):
    def test_says_in_one_line_that_there_is_no_display(self):
        there_is_none = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        done = subprocess.run([PROGRAM], env=there_is_none, capture_output=True, text=True, timeout=20)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("carrel run", done.stderr)

    def test_the_menu_lists_good_and_broken_drills_and_opens_one(self):
        with Desk(PROGRAM, "--drills", str(self.folder_of_drills())) as desk:
            ui = desk.wait(lambda ui: desk.find(ui, TITLE), "the good drill")
            self.assertEqual(ui["screen"], "menu")
            self.assertIn("broken.json:1:", ui["says"]["broken broken.json"])
            desk.click(TITLE)
            desk.screen("play")

    def folder_of_drills(self):
        folder = pathlib.Path(os.environ["TMPDIR"] if "TMPDIR" in os.environ else "/tmp") / f"drills-{os.getpid()}"
        folder.mkdir(exist_ok=True)
        self.addCleanup(lambda: subprocess.run(["rm", "-r", str(folder)], check=True))
        for name in ("square-knot.json", "square-knot.csv"):
            (folder / name).write_bytes((DRILLS / name).read_bytes())
        (folder / "broken.json").write_text("{")
        return folder


class Plays(unittest.TestCase):
    def test_mouse_and_keys_lead_the_tools_and_the_recording_proves_it(self):
        with Desk(PROGRAM, SQUARE) as desk:
            play(desk)
            right, left = tip(desk, "right"), tip(desk, "left")
            for _ in range(20):
                xdo("mousemove_relative", "--", -4, 2)
            desk.wait(lambda ui: tip(desk, "right")[0] < right[0] - 40, "the right tool to the left")
            xdo("keydown", "d")
            desk.wait(lambda ui: tip(desk, "left")[0] > left[0] + 20, "the left tool to the right")
            xdo("keyup", "d")
            xdo("key", "c")
            desk.click("Finish and score")
            recording = desk.screen("result")["says"]["recording"]
            result = replayed(recording)
            self.assertGreater(value_of(result, "path_right"), 1)
            self.assertGreater(value_of(result, "path_left"), 1)
            desk.click("Again")
            desk.screen("play")
            self.assertEqual(desk.end(), 0)
            self.assertEqual(len(desk.recordings()), 2, "the second attempt must not replace the first")

    def test_a_pause_stops_time_in_practice_and_does_nothing_in_an_exam(self):
        with Desk(PROGRAM, SQUARE) as desk:
            play(desk)
            xdo("key", "space")
            desk.wait(lambda ui: ui["says"]["paused"] == "yes" and desk.find(ui, "Go on"), "a pause")
            at = desk.says("time")
            time.sleep(0.5)
            self.assertEqual(desk.says("time"), at)
            xdo("key", "F1")
            desk.wait(lambda ui: ui["says"].get("keys") == "shown", "all keys")
        with Desk(PROGRAM, SQUARE, "--exam") as desk:
            play(desk)
            xdo("key", "space")
            before = float(desk.says("time"))
            desk.wait(lambda ui: float(ui["says"]["time"]) > before + 0.2, "time going on")
            self.assertIsNone(desk.find(desk.ui(), "Go on"))

    def test_closing_in_the_middle_finishes_the_recording(self):
        with Desk(PROGRAM, SQUARE) as desk:
            play(desk)
            desk.wait(lambda ui: float(ui["says"]["time"]) > 0.5, "half a second")
            self.assertEqual(desk.end(signal.SIGTERM), 0)
            self.assertTrue(replayed(desk.recordings()[0])["finished"])

    def test_a_kill_leaves_a_recording_that_verifies(self):
        with Desk(PROGRAM, SQUARE) as desk:
            play(desk)
            ui = desk.wait(lambda ui: float(ui["says"]["time"]) > 2, "two seconds")
            desk.end(signal.SIGKILL)
            result = replayed(desk.recordings()[0])
            self.assertFalse(result["finished"])
            self.assertGreaterEqual(result["duration_s"], float(ui["says"]["time"]) - 1)


class Reaches(unittest.TestCase):
    """Small screens, large letters, no mouse."""

    def walk(self, desk, ui):
        """Presses Tab once for each control; each must be whole on the screen when it has the focus."""
        reached, label = set(), None
        for _ in ui["controls"]:
            xdo("key", "Tab")
            now = desk.wait(lambda new, last=label: self.focus(new) not in (None, last), f"a focus after {label}", 10)
            label = self.focus(now)
            control = next(c for c in now["controls"] if c["focus"])
            width, height = now["size"]
            left, top, right, bottom = control["rect"]
            is_inside = left >= 0 and right <= width and top >= 0 and (bottom <= height or control["kind"] == "drill")
            self.assertTrue(is_inside, f"{label} is cut off: {control}")
            reached.add(label)
        self.assertEqual(reached, {c["label"] for c in ui["controls"]})

    @staticmethod
    def focus(ui):
        return next((c["label"] for c in ui["controls"] if c["focus"]), None)

    def test_tab_reaches_every_control_of_the_menu_and_the_settings(self):
        with Desk(PROGRAM, settings={"scale": 2}) as desk:
            desk.screen("menu")
            desk.resize(1024, 640)
            self.walk(desk, desk.wait(lambda ui: desk.find(ui, TITLE), "the drills"))
            desk.click("Settings")
            desk.screen("settings")
            self.walk(desk, desk.wait(lambda ui: desk.find(ui, "key picture"), "the keys"))

    def test_a_pause_and_a_result_are_used_without_a_mouse(self):
        with Desk(PROGRAM, SQUARE, settings={"scale": 2}) as desk:
            desk.screen("play")
            desk.resize(1024, 640)
            xdo("key", "space")
            desk.wait(lambda ui: ui["says"].get("paused") == "no", "ticks")
            xdo("key", "space")
            self.walk(desk, desk.wait(lambda ui: desk.find(ui, "Go on"), "a pause"))
            self.go_to(desk, "Finish and score")
            xdo("key", "space")
            self.walk(desk, desk.screen("result"))

    def go_to(self, desk, label):
        while self.focus(desk.ui()) != label:
            last = self.focus(desk.ui())
            xdo("key", "Tab")
            desk.wait(lambda ui, last=last: self.focus(ui) != last, f"a focus after {last}", 10)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
