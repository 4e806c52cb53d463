"""Whether every public declaration has a sentence of its own."""
import re

from lint_rules.cpp import blanked, declarations, name_in
from lint_rules.tree import line_of, report

ROOMS = ("sim", "tissue", "instruments", "scenarios")  # whose headers say what each public declaration is


def needs_none(declared, statement):
    """Whether a declaration says nothing of its own: it is hidden, a friend, declared elsewhere, or means what it must."""
    is_statement = declared.kind == "statement"
    forward = is_statement and re.match(r"(template\s*<[^;]*>\s*)?(struct|class|enum)\s[^({=]*$", statement)
    plain = re.match(r"(using\s+(?!\w+\s*=)|friend\b|static_assert\b|(virtual\s+)?~)", statement)
    means_what_it_must = re.search(r"=\s*(default|delete)$", statement) or re.match(
        r"(\w+)(& operator=\((const )?\1&&?( \w+)?\)|\(\1&&( \w+)?\))", statement)  # assigned or moved
    defined_here = declared.kind == "function" and "::" in name_in(statement)  # what its class declares
    return not declared.is_public or forward or plain or means_what_it_must or defined_here


def comment_of(text, declaration):
    """The `///` above a declaration or the `///<` beside it; nothing where it has neither."""
    lines = text.split("\n")
    first, head = line_of(text, declaration.start) - 1, line_of(text, declaration.head) - 1
    last = head if declaration.kind == "type" else line_of(text, declaration.end) - 1
    above = []
    while first - len(above) > 0 and re.match(r"\s*///(?!<)", lines[first - len(above) - 1]):
        above.insert(0, lines[first - len(above) - 1].strip()[3:].strip())
    beside = [line.split("///<", 1)[1].strip() for line in [*lines[first:head + 1], lines[last]] if "///<" in line]
    return " ".join(above) or " ".join(beside)


def check_comments(tree):
    for name in tree.files(".hpp"):
        if name.split("/")[0] not in ROOMS:
            continue
        text = tree.text(name)
        code = blanked(text)
        for declared in declarations(code):
            statement = code[declared.start:declared.head].strip()
            if needs_none(declared, statement):
                continue
            comment = comment_of(text, declared)
            where = line_of(text, declared.start)
            if not comment:
                report(name, where, f"`{name_in(statement)}` has no comment of its own",
                       "a sentence, /// above or ///< beside")
            elif re.match(r"[a-z][a-z]+[ ,:;.]", comment):
                report(name, where, f"the comment of `{name_in(statement)}` starts in the middle of a sentence",
                       "a whole one that stands alone")
