"""The files of the tree, and what is wrong with them."""
import os
import pathlib
import subprocess

findings = []


def report(path, line, what, right):
    findings.append((str(path), line, f"{what}; {right}"))


def line_of(text, offset):
    return text.count("\n", 0, offset) + 1


class Tree:
    """The files below `root` that git has or would take, as paths from there."""

    def __init__(self, root, below):
        self.root, self.below, self.texts = root, [b.rstrip("/") for b in below], {}
        self.names = sorted(self.known_to_git() or self.on_disk())

    def known_to_git(self):
        call = ["git", "ls-files", "-co", "--exclude-standard"]
        try:
            listed = subprocess.run(call, cwd=self.root, capture_output=True, text=True)
        except FileNotFoundError:
            return []
        return [name for name in listed.stdout.splitlines() if (self.root / name).is_file()]

    def on_disk(self):
        for folder, folders, names in os.walk(self.root):
            here = pathlib.Path(folder).relative_to(self.root)
            folders[:] = [f for f in folders if not f.startswith(".") and str(here / f) not in ("build", "out")]
            yield from (str(here / name) for name in names)

    def files(self, *ends):
        return [n for n in self.names if n.endswith(ends) and self.is_asked(n)]

    def is_asked(self, name):
        return not self.below or any(name == b or name.startswith(b + "/") for b in self.below)

    def text(self, name):
        if name not in self.texts:
            self.texts[name] = (self.root / name).read_text(encoding="utf-8", errors="replace")
        return self.texts[name]

    def is_generated(self, name):
        return "generated" in self.text(name).split("\n", 1)[0]
