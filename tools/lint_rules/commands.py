"""Whether the commands that pages show exist, and whether the quick ones run."""
import re
import subprocess

from lint_rules.tree import line_of, report

FOLDERS = ("sim", "tissue", "instruments", "scenarios", "assets", "app", "tests", "tools", "docs", "cmake")
QUICK = ("validate", "explain", "motion", "knot")  # commands of `carrel` that take seconds
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.S | re.M)
SPAN = re.compile(r"(?<!`)`([^`]+)`(?!`)")
CARREL = re.compile(r"(?:^|[\s(;&|])(?:build/|bin/)?(carrel(?:-bench)?)((?: +[^\s|;&>]+)*)")
MAKE = re.compile(r"(?:^|[;&|]\s*)make((?: +[^\s|;&>]+)*)")


def is_in_lab(name):
    return name.startswith("docs/lab/")


def same_lines(found):
    return re.sub(r"[^\n]", " ", found[0])


def shown_commands(text):
    """What a page shows as typed: offset and text of each line in a `sh` block and of each span of code."""
    for block in FENCE.finditer(text):
        for line in re.finditer(r"[^\n]+", block[2]):
            if block[1] == "sh":
                yield block.start(2) + line.start(), re.sub(r"(^|\s)#.*", "", line[0])
    for span in SPAN.finditer(FENCE.sub(same_lines, text)):
        yield span.start(), " ".join(span[1].split())


class Program:
    """What `carrel`, `make` and the tools know, asked of themselves; `carrel` only where it is built."""

    def __init__(self, root):
        self.root, self.helps = root, {}
        makefile = root / "Makefile"
        self.targets = set(re.findall(r"^([\w-]+):", makefile.read_text(), re.M)) if makefile.exists() else set()

    def help(self, program, *command):
        key = (program, *command)
        if key not in self.helps:
            try:
                path = str(self.root / "build" / program)
                done = subprocess.run([path, *command, "--help"], capture_output=True, text=True, timeout=60)
                self.helps[key] = done.stdout if done.returncode == 0 else ""
            except OSError:
                self.helps[key] = None
        return self.helps[key]

    def commands(self, program):
        text = self.help(program) or ""
        return re.findall(r"^  ([a-z][\w-]*)(?: |$)", text.split("Subcommands:")[-1], re.M)


def check_commands(tree, program, name, text):
    for offset, shown in shown_commands(text):
        where = line_of(text, offset)
        for found in CARREL.finditer(shown):
            check_carrel(program, name, where, found[1], found[2].split())
        for found in MAKE.finditer(shown):
            for word in found[1].split():
                if re.match(r"[a-z]", word) and "=" not in word and word not in program.targets:
                    report(name, where, f"`make {word}` does not exist", "a target of the Makefile")
        if re.match(r"(%s)/[\w./*-]*$" % "|".join(FOLDERS), shown) and not list(tree.root.glob(shown.rstrip("/"))):
            report(name, where, f"`{shown}` does not exist", "a path in the tree")


def check_carrel(program, name, where, called, words):
    if program.help(called) is None or not words or not re.match(r"-*[a-z]", words[0]):
        return
    command = [] if words[0].startswith("-") else [words[0]]
    if command and called == "carrel" and command[0] not in program.commands(called):
        report(name, where, f"`{called} {command[0]}` does not exist", f"a command of `{called} --help`")
        return
    known = program.help(called, *(command if called == "carrel" else [])) or ""
    if called == "carrel-bench" or command == ["bench"]:
        known += program.help("carrel-bench") or ""
        rest = words[1:] if called == "carrel" else words
        suite = next((word for word in rest if re.match(r"[a-z]", word)), None)
        if suite and not re.search(rf"\b{re.escape(suite.strip(',.'))}\b", known):
            report(name, where, f"there is no suite `{suite}`", "one of `carrel bench --help`")
    for word in words:
        option = re.match(r"--[a-z][\w-]*", word)
        if option and not re.search(rf"{option[0]}\b(?!-)", known):
            report(name, where, f"`{called} {' '.join(command)}` knows no {option[0]}", "an option of its --help")


def run_commands(tree):
    """Runs what pages show in `sh` blocks and what takes seconds: each must end with 0."""
    for name in tree.files(".md"):
        text = "" if is_in_lab(name) else tree.text(name)
        for offset, shown in shown_commands(text):
            is_quick = re.match(r"build/carrel (%s)\b" % "|".join(QUICK), shown)
            if not is_quick or "…" in shown or text[offset] == "`":
                continue
            shown = with_files(tree, text, shown)
            done = subprocess.run(shown, shell=True, cwd=tree.root, capture_output=True, text=True, timeout=120)
            print(f"{name}: {shown}: {'as it should' if done.returncode == 0 else done.returncode}")
            if done.returncode:
                report(name, line_of(text, offset), f"`{shown}` ends with {done.returncode}", done.stderr.strip()[:200])


def with_files(tree, text, shown):
    """The command with `mine.json`, a drill that the page shows, in out/, the folder for all that commands write."""
    (tree.root / "out").mkdir(exist_ok=True)
    drill = next((block[2] for block in FENCE.finditer(text) if block[1] == "json"), None)
    if drill and "mine.json" in shown:
        (tree.root / "out/mine.json").write_text(drill)
        return shown.replace("mine.json", "out/mine.json")
    return shown
