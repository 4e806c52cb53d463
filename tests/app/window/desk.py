"""A person at the window: starts the program, finds controls by their labels, clicks and types by real X events."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time


class Desk:
    """One run of the program on the display of the environment, with settings and recordings of its own."""

    def __init__(self, program, *arguments, settings=None):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="carrel-window-"))
        self.dump = self.folder / "ui.jsonl"
        self.environment = dict(os.environ, HOME=str(self.folder))
        for name in ("CONFIG", "DATA", "CACHE"):
            self.environment[f"XDG_{name}_HOME"] = str(self.folder / name.lower())
        if settings:
            (self.folder / "config/carrel").mkdir(parents=True)
            (self.folder / "config/carrel/settings.json").write_text(json.dumps(settings))
        self.said = open(self.folder / "said", "w+")
        self.process = subprocess.Popen([program, "play", *arguments, "--ui-dump", str(self.dump)],
                                        env=self.environment, stderr=self.said, start_new_session=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.said.close()
        shutil.rmtree(self.folder)

    def ui(self):
        """The screen as the last whole line of the dump has it; None before the first frame."""
        try:
            lines = self.dump.read_bytes()[-200_000:].split(b"\n")
        except FileNotFoundError:
            return None
        return json.loads(lines[-2]) if len(lines) > 1 and lines[-2].startswith(b"{") else None

    def wait(self, holds, what, seconds=20):
        """The first screen of which `holds` is true; fails after so many seconds."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            ui = self.ui()
            if ui and holds(ui):
                return ui
            if self.process.poll() is not None:
                self.said.seek(0)
                raise AssertionError(f"the program ended with {self.process.returncode}: {self.said.read()}")
            time.sleep(0.02)
        raise AssertionError(f"after {seconds} s still not: {what}; the screen is {self.ui()}")

    def screen(self, name, seconds=20):
        return self.wait(lambda ui: ui["screen"] == name, f"the screen {name}", seconds)

    @staticmethod
    def find(ui, label):
        return next((c for c in ui["controls"] if c["label"] == label), None)

    def control(self, label, seconds=20):
        ui = self.wait(lambda ui: self.find(ui, label), f"a control {label}", seconds)
        return self.find(ui, label)

    def click(self, label):
        left, top, right, bottom = self.control(label)["rect"]
        xdo("mousemove", round((left + right) / 2), round((top + bottom) / 2))
        time.sleep(0.15)  # a frame at least, so that the button knows that the pointer is on it
        xdo("click", 1)

    def resize(self, width, height):
        xdo("search", "--name", "^Carrel$", "windowsize", width, height)
        self.wait(lambda ui: ui["size"] == [width, height], "the new size")

    def says(self, name):
        return (self.ui() or {"says": {}})["says"].get(name, "")

    def recordings(self):
        return sorted((self.folder / "data").rglob("*.carrel"))

    def end(self, how=signal.SIGTERM):
        self.process.send_signal(how)
        return self.process.wait(60)


def xdo(*words):
    """One call of xdotool: real events by XTest."""
    subprocess.run(["xdotool", *map(str, words)], check=True)


def picture(file):
    """What the display shows, as a PNG; for people."""
    subprocess.run(["import", "-window", "root", str(file)], check=True)
