"""Whether pages are short, tell what is and not what was, and lead somewhere."""
import re

from lint_rules.commands import FENCE, Program, check_commands, is_in_lab, same_lines
from lint_rules.tree import line_of, report

PAGE_LINES = 150  # of a page in docs/
DIARY = re.compile(r"\b(until now|used to be|formerly|previously|originally|recently|for now|has since|these days|"
                   r"(?:since|until|before|as of) 20\d\d|no longer(?! than))\b", re.I)
DATE = re.compile(r"\b20\d\d-\d\d-\d\d\b")


def check_pages(tree):
    program = Program(tree.root)
    for name in tree.files(".md"):
        text = tree.text(name)
        check_links(tree, name, text)
        if is_in_lab(name) or tree.is_generated(name):
            continue
        if name.startswith("docs/") and text.count("\n") > PAGE_LINES:
            report(name, PAGE_LINES, f"a page of {text.count(chr(10))} lines", f"at most {PAGE_LINES}")
        if name != "CHANGELOG.md":
            check_diary(name, text)
        check_commands(tree, program, name, text)


def check_diary(name, text):
    blocks = [(found.start(), found[0]) for found in re.finditer(r"(?:[^\n]+\n?)+", text)]
    is_shown = [block.lstrip().startswith(("|", "![", "<!--")) for _, block in blocks]
    for number, (offset, block) in enumerate(blocks):
        beside = is_shown[max(0, number - 1):number + 2]
        date = DATE.search(block)
        if date and not any(beside):
            report(name, line_of(text, offset + date.start()), f"the date {date[0]} is in no caption of a table",
                   "the present tense, and what was before in docs/lab")
        for word in DIARY.finditer(block):
            report(name, line_of(text, offset + word.start()), f"`{word[0]}` tells how it was before",
                   "the present tense, and what was before in docs/lab")


def check_links(tree, name, text):
    for found in re.finditer(r"\]\(([^)\s#]+)(?:#[^)]*)?\)|(?:src|href)=\"([^\"#]+)\"", FENCE.sub(same_lines, text)):
        link = found[1] or found[2]
        if not re.match(r"\w+:", link) and not (tree.root / name).parent.joinpath(link).exists():
            report(name, line_of(text, found.start()), f"the link to {link} leads nowhere", "a file that exists")
