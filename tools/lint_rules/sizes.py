"""How long lines, functions, files and pages are."""
from lint_rules.cpp import functions
from lint_rules.tree import report

COLUMNS = 120        # of a line of code, of CMake and of a page
FILE_LINES = 450     # of a file of code
FUNCTION_LINES = 60  # of any function, from its first line to its closing brace
MEDIAN_LINES = 8     # of all functions


def check_functions(tree):
    lengths = []
    for name in tree.files(".cpp", ".hpp"):
        for function, first, last in functions(tree.text(name)):
            lengths.append(last - first + 1)
            if lengths[-1] > FUNCTION_LINES:
                report(name, first, f"`{function}` has {lengths[-1]} lines", f"at most {FUNCTION_LINES}")
    median = sorted(lengths)[len(lengths) // 2] if lengths else 0
    if median > MEDIAN_LINES and not tree.below:
        report(".", 1, f"the median function has {median} lines", f"at most {MEDIAN_LINES}")


def check_lengths(tree):
    for name in tree.files(".cpp", ".hpp", ".cmake", "CMakeLists.txt", ".md"):
        is_free = name.endswith(".md") and tree.is_generated(name)
        for number, line in enumerate(tree.text(name).split("\n"), 1):
            if len(line) > COLUMNS and not is_free:
                report(name, number, f"{len(line)} columns", f"at most {COLUMNS}")
        lines = tree.text(name).count("\n")
        if name.endswith((".cpp", ".hpp")) and lines > FILE_LINES:
            report(name, lines, f"a file of {lines} lines", f"at most {FILE_LINES}")
