"""What clang-format and clang-tidy say."""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess

from lint_rules.tree import report


def check_format(tree):
    names = tree.files(".cpp", ".hpp")
    try:
        done = subprocess.run(["clang-format", "--dry-run", *names], cwd=tree.root, capture_output=True, text=True)
    except FileNotFoundError:
        report("tools/lint", 1, "there is no clang-format", "tools/packages.sh clang-format")
        return
    seen = set()
    for name, line in re.findall(r"^(\S+?):(\d+):\d+: \w+: code should be clang-formatted", done.stderr, re.M):
        if name not in seen:
            report(name, int(line), "not as clang-format leaves it", "make format")
        seen.add(name)


def changed_since(tree, commit):
    call = ["git", "diff", "--name-only", commit]
    done = subprocess.run(call, cwd=tree.root, capture_output=True, text=True)
    if done.returncode:
        report("tools/lint", 1, f"git knows no commit {commit}", "--since with one that it knows")
    return set(done.stdout.split())


def units_of(folder, names):
    """What is compiled: files that take in several sources each, of them those with one of `names`."""
    for entry in json.loads((folder / "compile_commands.json").read_text()):
        unit = pathlib.Path(entry["file"])
        taken_in = re.findall(r'#include "(.*)"', unit.read_text()) if "Unity" in unit.parts else [entry["file"]]
        if any(os.path.relpath(source, folder.parent.parent) in names for source in taken_in):
            yield str(unit)


def tidy(tree, since):
    """clang-tidy, on the sources that differ from a commit or on all, by a build folder of its own. Sources of a room
    are looked at together, as a unity build compiles them: their headers are read once."""
    names = set(tree.files(".cpp"))
    if since:
        names &= changed_since(tree, since)
    if not names:
        return
    folder = tree.root / "build" / "tidy"
    configure = ["cmake", "-S", str(tree.root), "-B", str(folder), "-G", "Ninja", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                 "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON"]
    done = subprocess.run(configure, capture_output=True, text=True)
    if done.returncode:
        report("CMakeLists.txt", 1, "cannot be configured for clang-tidy", done.stderr.strip()[-300:])
        return

    def look_at(unit):
        call = ["clang-tidy", "--quiet", "-p", str(folder), "--extra-arg=-Wno-unknown-warning-option", unit]
        return subprocess.run(call, cwd=tree.root, capture_output=True, text=True).stdout

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for said in pool.map(look_at, units_of(folder, names)):
            for path, line, what in re.findall(r"^(\S+?):(\d+):\d+: (?:warning|error): (.*)", said, re.M):
                report(os.path.relpath(path, tree.root), int(line), what, "code that clang-tidy leaves alone")
