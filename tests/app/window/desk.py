"""A person at the window: starts the program, finds controls by their labels, clicks and types by real X events."""
import ctypes
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
        self.dump, self.scene = self.folder / "ui.jsonl", self.folder / "scene.jsonl"
        self.environment = dict(os.environ, HOME=str(self.folder))
        for name in ("CONFIG", "DATA", "CACHE"):
            self.environment[f"XDG_{name}_HOME"] = str(self.folder / name.lower())
        if settings:
            (self.folder / "config/carrel").mkdir(parents=True)
            (self.folder / "config/carrel/settings.json").write_text(json.dumps(settings))
        self.said = open(self.folder / "said", "w+")
        self.start(program, *arguments)

    def start(self, program, *arguments):
        """Starts the program, or starts it again when it has ended."""
        self.dump.unlink(missing_ok=True)
        self.process = subprocess.Popen([program, "play", *arguments, "--ui-dump", str(self.dump),
                                         "--scene-dump", str(self.scene)],
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

    def play(self, seconds=20):
        """Begins the drill on the screen."""
        self.screen("play", seconds)
        self.click("Begin")
        self.wait(lambda ui: ui["says"].get("paused") == "no", "ticks", seconds)

    def resize(self, width, height):
        xdo("search", "--name", "^Carrel$", "windowsize", width, height)
        self.wait(lambda ui: ui["size"] == [width, height], "the new size")

    def says(self, name):
        return (self.ui() or {"says": {}})["says"].get(name, "")

    def memory_mb(self):
        """What the program has in memory."""
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        return int(next(line for line in status.splitlines() if line.startswith("VmRSS")).split()[1]) / 1024

    def recordings(self):
        return sorted((self.folder / "data").rglob("*.carrel"))

    def end(self, how=signal.SIGTERM):
        self.process.send_signal(how)
        return self.process.wait(60)


def xdo(*words):
    """One call of xdotool: real events by XTest."""
    subprocess.run(["xdotool", *map(str, words)], check=True)


class Image(ctypes.Structure):
    """The head of Xlib's XImage: as far as its pixels."""
    _fields_ = [("width", ctypes.c_int), ("height", ctypes.c_int), ("offset", ctypes.c_int), ("format", ctypes.c_int),
                ("data", ctypes.c_void_p), ("order", ctypes.c_int), ("unit", ctypes.c_int), ("bit", ctypes.c_int),
                ("pad", ctypes.c_int), ("depth", ctypes.c_int), ("line", ctypes.c_int)]


class Server:
    """The X server, by calls of XTest instead of processes: hundreds of events a second."""

    def __init__(self):
        self.x, self.test = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XStringToKeysym.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(None))
        self.x.XDefaultRootWindow.restype = ctypes.c_ulong
        self.root = ctypes.c_ulong(self.x.XDefaultRootWindow(self.display))
        self.x.XGetImage.restype = self.x.XGetSubImage.restype = ctypes.POINTER(Image)
        self.images = {}

    def pixels(self, left, top, wide, high):
        """What the display shows there now, as bytes."""
        everything, by_pixel = ctypes.c_ulong(-1), 2
        place = (self.display, self.root, left, top, wide, high, everything, by_pixel)
        if (wide, high) not in self.images:
            self.images[wide, high] = self.x.XGetImage(*place)
        image = self.images[wide, high]
        self.x.XGetSubImage(*place, image, 0, 0)
        return ctypes.string_at(image.contents.data, image.contents.line * high)

    def send(self, what, *words):
        """One event as window_by_hand names it: move, wheel, button, key."""
        if what == "move":
            self.test.XTestFakeRelativeMotionEvent(self.display, int(words[0]), int(words[1]), 0)
        elif what == "wheel":
            number = 4 if int(words[0]) > 0 else 5
            for down in [1, 0] * abs(int(words[0])):
                self.test.XTestFakeButtonEvent(self.display, number, down, 0)
        elif what == "button":
            self.test.XTestFakeButtonEvent(self.display, int(words[0]), int(words[1]), 0)
        elif what == "key":
            name = {"Shift": "Shift_L"}.get(words[0], words[0].lower() if len(words[0]) == 1 else words[0])
            code = self.x.XKeysymToKeycode(self.display, ctypes.c_ulong(self.x.XStringToKeysym(name.encode())))
            self.test.XTestFakeKeyEvent(self.display, code, int(words[1]), 0)
        self.x.XFlush(self.display)


def picture(file):
    """What the display shows, as a PNG; for people."""
    subprocess.run(["import", "-window", "root", str(file)], check=True)
