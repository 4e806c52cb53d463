#!/usr/bin/env python3
"""Puts small faults into a scratch copy of the tree, one at a time, and says which test notices each.

faults.txt lists them. Only the programs that a fault names are built and run, never hashes_test: a pinned hash is
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
SOURCES = {".cpp", ".hpp", ".in"}
MOST_SECONDS = 600  # of a test program; one that a fault keeps from ending has noticed it


class Fault:
    KEYS = ("wrong", "in", "before", "after", "test")

    def __init__(self, number, row):
        if unknown := set(row) - set(self.KEYS):
            raise SystemExit(f"faults.txt: fault {number}: unknown key '{unknown.pop()}'; keys are {', '.join(self.KEYS)}")
        for key in self.KEYS:
            if key not in row:
                raise SystemExit(f"faults.txt: fault {number}: '{key}' is missing")
        self.number, self.wrong, self.room = number, row["wrong"], row["in"]
        self.before, self.after = (row[key].replace("\\n", "\n") for key in ("before", "after"))
        programs, _, self.filter = row["test"].partition(" ")
        self.programs = programs.split("|")

    @property
    def program(self):
        """The first of those it names that the build has."""
        known = (BUILD / "build.ninja").read_text()
        there = [name for name in self.programs if f"build tests/{name}: " in known]
        if not there:
            raise SystemExit(f"faults.txt: fault {self.number} ({self.wrong}): no test program {' or '.join(self.programs)}")
        return there[0]

    def file(self):
        """The one source under its folder that holds the snippet, once: files may move within a room."""
        found = [path for path in sorted((ROOT / self.room).rglob("*"))
                 if path.suffix in SOURCES and self.before in path.read_text()]
        times = sum(path.read_text().count(self.before) for path in found)
        if times != 1:
            raise SystemExit(f"faults.txt: fault {self.number} ({self.wrong}): found {times} times, not once, under "
                             f"{self.room}/: {self.before}")
        return found[0].relative_to(ROOT)


def read_faults(path):
    """Blocks of 'key: value' lines with an empty line between two; '#' begins a comment."""
    rows, row = [], {}
    for line in path.read_text().splitlines() + [""]:
        if line.startswith("#"):
            continue
        if not line.strip():
            if row:
                rows.append(row)
            row = {}
            continue
        key, _, value = line.partition(": ")
        row[key] = value
    return [Fault(i + 1, row) for i, row in enumerate(rows)]


def copy_tree():
    """Brings the scratch copy up to date; what is the same keeps its time, so that nothing is built anew for it."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True)
    names = listed.stdout.split("\n") if listed.returncode == 0 else [
        str(path.relative_to(ROOT)) for path in ROOT.rglob("*") if path.relative_to(ROOT).parts[0] not in ("build", "out", ".git")]
    wanted = {name for name in names if name and (ROOT / name).is_file()}
    for name in wanted:
        data = (ROOT / name).read_bytes()
        if name.endswith(("CMakeLists.txt", ".cmake")):
            data = data.replace(b"-Werror", b"-Wno-error")  # a fault may leave something unused
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
    subprocess.run(["cmake", "-S", TREE, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=OFF"],
                   check=True, env=environment(), stdout=subprocess.DEVNULL)


def build(programs):
    """None, or what the compiler says."""
    done = subprocess.run(["ninja", "-C", BUILD, *sorted(programs)], env=environment(), capture_output=True, text=True)
    return None if done.returncode == 0 else done.stdout[-3000:]


def first_failure(program, only):
    """The first test of a program that fails, or None."""
    try:
        done = subprocess.run([BUILD / "tests" / program, f"--gtest_filter={only}", "--gtest_fail_fast"], cwd=BUILD / "tests",
                              capture_output=True, text=True, errors="replace", timeout=MOST_SECONDS)
    except subprocess.TimeoutExpired:
        return f"{program} does not end"
    if done.returncode == 0:
        return None if re.search(r"\[  PASSED  \] [1-9]", done.stdout) else f"{program} has no test {only}"
    if failed := re.search(r"\[  FAILED  \] (\S+?),? ", done.stdout):
        return failed[1]
    began = re.findall(r"\[ RUN      \] (\S+)", done.stdout)
    return f"{began[-1] if began else program} (stops: {done.stderr.strip().splitlines()[-1:] or done.returncode})"


def seen_by(fault):
    """What notices it; None: nothing in its program does."""
    path = TREE / fault.file()
    sound = path.read_text()
    path.write_text(sound.replace(fault.before, fault.after))
    try:
        if problem := build([fault.program]):
            raise SystemExit(f"faults.txt: fault {fault.number} ({fault.wrong}) does not compile:\n{problem}")
        noticed = first_failure(fault.program, fault.filter) if fault.filter else None
        return noticed or first_failure(fault.program, "*")
    finally:
        path.write_text(sound)


def main():
    parse = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parse.add_argument("--list", action="store_true", help="say which there are, and build nothing")
    parse.add_argument("--room", help="only those under this folder")
    parse.add_argument("--only", type=int, nargs="+", metavar="N", help="only these numbers")
    options = parse.parse_args()
    sys.stdout.reconfigure(line_buffering=True)
    faults = read_faults(pathlib.Path(__file__).with_name("faults.txt"))
    faults = [f for f in faults if (not options.room or f.room.startswith(options.room)) and
              (not options.only or f.number in options.only)]
    files = {f.number: f.file() for f in faults}
    if options.list:
        for f in faults:
            print(f"{f.number:3} {files[f.number]}: {f.wrong}")
        return 0
    copy_tree()
    configure()
    if problem := build({f.program for f in faults}):
        raise SystemExit("the tree does not build:\n" + problem)
    for program, only in sorted({(f.program, f.filter) for f in faults if f.filter}):
        if failed := first_failure(program, only):
            print(f"without any fault: {failed}")
            return 2
    unseen = 0
    for f in faults:
        noticed = seen_by(f)
        unseen += noticed is None
        print(f"{f.number:3} {'seen' if noticed else 'UNSEEN':6} {files[f.number]}: {f.wrong}" + (f"  [{noticed}]" if noticed else ""))
    print(f"{len(faults)} faults, {len(faults) - unseen} seen, {unseen} unseen")
    return 3 if unseen else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except SystemExit as stop:
        if isinstance(stop.code, str):
            print(stop.code, file=sys.stderr)
            sys.exit(2)
        raise
