"""What clang-format and clang-tidy say."""
import os
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


def changed(root):
    for base in ("origin/main", "HEAD~"):
        done = subprocess.run(["git", "diff", "--name-only", base], cwd=root, capture_output=True, text=True)
        if done.returncode == 0:
            return set(done.stdout.split())
    return set()


def tidy(tree, everything):
    """clang-tidy, file by file, by a build folder of its own in which every file is compiled by itself."""
    names = [n for n in tree.files(".cpp") if everything or n in changed_files(tree)]
    if not names:
        return
    folder = tree.root / "build" / "tidy"
    configure = ["cmake", "-S", str(tree.root), "-B", str(folder), "-G", "Ninja", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                 "-DCMAKE_UNITY_BUILD=OFF", "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON"]
    done = subprocess.run(configure, capture_output=True, text=True)
    if done.returncode:
        report("CMakeLists.txt", 1, "cannot be configured for clang-tidy", done.stderr.strip()[-300:])
        return
    for name in names:
        call = ["clang-tidy", "--quiet", "-p", str(folder), "--extra-arg=-Wno-unknown-warning-option", name]
        done = subprocess.run(call, cwd=tree.root, capture_output=True, text=True)
        for path, line, what in set(re.findall(r"^(\S+?):(\d+):\d+: (?:warning|error): (.*)", done.stdout, re.M)):
            report(os.path.relpath(path, tree.root), int(line), what, "code that clang-tidy leaves alone")


def changed_files(tree):
    if not hasattr(tree, "changed"):
        tree.changed = changed(tree.root)
    return tree.changed
