#!/usr/bin/env python3
"""Puts small faults into a scratch copy of the tree, one at a time, and says which test notices each.

faults.txt lists them. Only the program that a fault names is built and run, never hashes_test: a pinned hash is
renewed with every change that is meant, and the fault with it. Exit 0: all were seen. 2: a row is wrong, or a test
fails without any fault. 3: one was seen by no test.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRATCH = ROOT / "build" / "mutants"
TREE, BUILD = SCRATCH / "tree", SCRATCH / "build"
SOURCES = {".cpp", ".hpp"}
MOST_SECONDS = 600  # of a test program; one that a fault keeps from ending has noticed it
# A fault may leave something unused; a program of tests that needs carrel says so in its row.
COPIED_OTHERWISE = {b"-Werror": b"-Wno-error", b"add_dependencies(${name} carrel)": b""}


class BadRow(Exception):
    """What is wrong with a row of faults.txt."""


class Fault:
    KEYS = ("wrong", "in", "before", "after", "test")

    def __init__(self, number, row):
        self.number = number
        if unknown := set(row) - set(self.KEYS):
            raise self.bad(f"unknown key '{unknown.pop()}', expected {', '.join(self.KEYS)}")
        if missing := set(self.KEYS) - set(row):
            raise self.bad(f"'{missing.pop()}' is missing")
        self.wrong, self.room = row["wrong"], row["in"]
        self.before, self.after = (row[key].replace("\\n", "\n") for key in ("before", "after"))
        programs, _, only = row["test"].partition(" ")
        self.programs, self.only = programs.split("+"), only or "*"

    def bad(self, why):
        return BadRow(f"faults.txt: fault {self.number}: {why}")

    def file(self):
        """The one source under its folder that holds the snippet, once: files may move within a room."""
        times = {path: path.read_text().count(self.before)
                 for path in sorted((ROOT / self.room).rglob("*")) if path.suffix in SOURCES}
        if sum(times.values()) != 1:
            raise self.bad(f"found {sum(times.values())} times, not once, under {self.room}/: {self.before}")
        return next(path for path in times if times[path]).relative_to(ROOT)


def read_faults(path):
    """Blocks of 'key: value' lines with an empty line between two; '#' begins a comment."""
    text = re.sub(r"^#.*\n", "", path.read_text(), flags=re.MULTILINE)
    blocks = [block for block in re.split(r"\n\s*\n", text.strip()) if block]
    return [Fault(number, dict(line.partition(": ")[::2] for line in block.split("\n")))
            for number, block in enumerate(blocks, 1)]


def tracked_files():
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True)
    if listed.returncode == 0:
        return {name for name in listed.stdout.split("\n") if name and (ROOT / name).is_file()}
    names = {path.relative_to(ROOT) for path in ROOT.rglob("*") if path.is_file()}
    return {str(name) for name in names if name.parts[0] not in ("build", "out", ".git")}


def copy_tree():
    """Brings the scratch copy up to date; what is the same keeps its time, so that nothing is built anew for it."""
    wanted = tracked_files()
    for name in wanted:
        data = (ROOT / name).read_bytes()
        if name.endswith(("CMakeLists.txt", ".cmake")):
            for ours, otherwise in COPIED_OTHERWISE.items():
                data = data.replace(ours, otherwise)
        path = TREE / name
        if not path.exists() or path.read_bytes() != data:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
            shutil.copymode(ROOT / name, path)
    for path in TREE.rglob("*"):
        if path.is_file() and str(path.relative_to(TREE)) not in wanted:
            path.unlink()


def environment():
    env = dict(os.environ)
    if shutil.which("ccache"):
        env.setdefault("CMAKE_CXX_COMPILER_LAUNCHER", "ccache")
        env.setdefault("CCACHE_SLOPPINESS", "pch_defines,time_macros,include_file_mtime,include_file_ctime")
        env["CXXFLAGS"] = "-fpch-preprocess"
    return env


def configure():
    options = ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=OFF"]
    subprocess.run(["cmake", "-S", TREE, "-B", BUILD, *options], check=True, env=environment(),
                   stdout=subprocess.DEVNULL)


def build(programs):
    """None, or what the compiler says."""
    done = subprocess.run(["ninja", "-C", BUILD, *sorted(programs)], env=environment(), capture_output=True, text=True)
    return None if done.returncode == 0 else done.stdout[-3000:]


def first_failure(program, only):
    """The first of these tests of a program that fails, or None."""
    try:
        done = subprocess.run([BUILD / "tests" / program, f"--gtest_filter={only}", "--gtest_fail_fast"],
                              cwd=BUILD / "tests", capture_output=True, text=True, errors="replace",
                              timeout=MOST_SECONDS)
    except subprocess.TimeoutExpired:
        return f"{program} does not end"
    if done.returncode == 0:
        return None if re.search(r"\[  PASSED  \] [1-9]", done.stdout) else f"{program} has no test {only}"
    if failed := re.search(r"\[  FAILED  \] (\S+?),? ", done.stdout):
        return failed[1]
    began = re.findall(r"\[ RUN      \] (\S+)", done.stdout)
    return f"{began[-1] if began else program} (stops: {(done.stderr.strip().splitlines() or [done.returncode])[-1]})"


def noticed_by(fault, file):
    """The test that notices a fault in a file; None: none of those that it names does."""
    path = TREE / file
    sound = path.read_text()
    path.write_text(sound.replace(fault.before, fault.after))
    try:
        if problem := build(fault.programs):
            raise fault.bad(f"does not compile:\n{problem}")
        return first_failure(fault.programs[-1], fault.only)
    finally:
        path.write_text(sound)


def try_all(faults):
    """Rows of the table. What notices a fault is None where nothing does, and empty where it does not compile."""
    for fault in faults:
        file = fault.file()
        try:
            noticed = noticed_by(fault, file)
        except BadRow as bad:
            print(bad, file=sys.stderr)
            noticed = ""
        print(f"{fault.number}: {noticed or 'unseen'}", file=sys.stderr, flush=True)
        yield fault, file, noticed


def print_table(table):
    print("| | fault | room | noticed by |\n|---|---|---|---|")
    for fault, file, noticed in table:
        print(f"| {fault.number} | {fault.wrong} | {file.parent} | {noticed or '**nothing**'} |")
    seen = sum(bool(noticed) for _, _, noticed in table)
    print(f"\n{len(table)} faults in {len({file.parent for _, file, _ in table})} rooms, {seen} noticed", flush=True)


def main():
    parse = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parse.add_argument("--list", action="store_true", help="say which there are, and build nothing")
    parse.add_argument("--room", default="", help="only those under this folder")
    parse.add_argument("--only", type=int, nargs="+", metavar="N", help="only these numbers")
    options = parse.parse_args()
    faults = [f for f in read_faults(pathlib.Path(__file__).with_name("faults.txt"))
              if f.room.startswith(options.room) and (not options.only or f.number in options.only)]
    files = [f.file() for f in faults]
    if options.list:
        for fault, file in zip(faults, files):
            print(f"{fault.number:3} {file}: {fault.wrong}")
        return 0
    copy_tree()
    configure()
    if problem := build({name for f in faults for name in f.programs}):
        raise BadRow("the tree does not build:\n" + problem)
    for program, only in sorted({(f.programs[-1], f.only) for f in faults}):
        if failed := first_failure(program, only):
            raise BadRow(f"without any fault: {failed}")
    table = list(try_all(faults))
    print_table(table)
    results = [noticed for _, _, noticed in table]
    return 2 if "" in results else 3 if None in results else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except BadRow as bad:
        print(bad, file=sys.stderr)
        sys.exit(2)
