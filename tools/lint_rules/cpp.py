"""C++ as clang-format leaves it: its declarations and its functions."""
import re

from lint_rules.tree import line_of

TOKEN = re.compile(r"""//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'"""
                   r"|^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*", re.S | re.M)


def blanked(text):
    """The text with blanks for comments, literals and preprocessor lines; every offset stays."""
    return TOKEN.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def closing(code, opening):
    """Offset of the brace that closes the one at `opening`."""
    depth = 0
    for found in re.compile(r"[{}]").finditer(code, opening):
        depth += 1 if found[0] == "{" else -1
        if depth == 0:
            return found.start()
    return len(code) - 1


def is_body(statement):
    """Whether the brace after `statement` opens a function's body; else it opens an initialiser."""
    flat = statement
    while re.search(r"\([^()]*\)", flat):
        flat = re.sub(r"\([^()]*\)", "\0", flat)
    flat = re.sub(r"operator\s*[^\s\0\w]+", "operator", flat)
    while re.search(r"<[^<>]*>", flat):
        flat = re.sub(r"<[^<>]*>", "", flat)
    if "\0" not in flat or "=" in flat:
        return False
    initialises = re.search(r"\0[^:]*[^:]:[^:]", flat)
    return not initialises or flat.rstrip()[-1:] in ("\0", "}")


class Declaration:
    """One declaration at namespace or class scope: offsets of its first character, its `{` or `;`, and its end."""

    def __init__(self, kind, is_public, start, head, end):
        self.kind, self.is_public, self.start, self.head, self.end = kind, is_public, start, head, end


def declarations(code):
    # A scope: what opened it, whether what stands there now is public, and whether what is `public:` there is.
    scopes, start, i, depth = [["namespace", True, True]], None, 0, 0
    while i < len(code):
        c = code[i]
        if start is None and not c.isspace() and c not in "};":
            start = i
        if c not in "()[]{};:,":
            i += 1
            continue
        statement = code[start:i].strip() if start is not None else ""
        kind, is_public, _ = scopes[-1]
        if c in "([":
            depth += 1
        elif c in ")]":
            depth -= 1
        elif c == "{" and depth > 0:
            i = closing(code, i)
        elif c == "{":
            plain = re.sub(r"^(template\s*<.*?>\s*)+(?=struct|class|union)", "", statement, flags=re.S)
            word = re.match(r"(inline\s+)?(namespace|extern|struct|class|union|enum)\b", plain)
            if word and word[2] in ("namespace", "extern") and "(" not in plain:
                scopes.append(["namespace", plain != "namespace" and is_public, True])
                start = None
            elif word and not is_body(statement):
                yield Declaration("type", is_public, start, i, closing(code, i))
                scopes.append([word[2], is_public and word[2] != "class", is_public])
                start = None
            elif is_body(statement):
                end = closing(code, i)
                yield Declaration("function", is_public, start, i, end)
                start, i = None, end
            else:
                i = closing(code, i)
        elif c == ";" and depth == 0:
            if statement:
                yield Declaration("statement", is_public, start, i, i)
            start = None
        elif kind == "enum" and depth == 0 and c in ",}":
            if statement:
                yield Declaration("enumerator", is_public, start, i, i)
            start = None
            if c == "}":
                scopes.pop()
        elif c == "}":
            if len(scopes) > 1:
                scopes.pop()
            start = None
        elif c == ":" and statement in ("public", "private", "protected"):
            scopes[-1][1] = scopes[-1][2] and statement == "public"
            start = None
        i += 1


def name_in(statement):
    """The name that a declaration gives, or its first word."""
    flat = re.sub(r"\[\[.*?\]\]", "", statement)
    while re.search(r"<[^<>()]*>", flat):
        flat = re.sub(r"<[^<>()]*>", "", flat)
    found = (re.match(r"\s*(?:TEST|TEST_F|TEST_P)\(\w+,\s*(\w+)", flat)
             or re.search(r"([\w:~]+|operator\W+)\s*\(", flat)
             or re.search(r"(\w+)\s*(?:\[\w*\]\s*)*(?:=|\{|:(?!:)|,|$)", flat))
    return found[1] if found else flat.split()[0]


def functions(text):
    code = blanked(text)
    for found in declarations(code):
        if found.kind == "function":
            yield name_in(code[found.start:found.head]), line_of(code, found.start), line_of(code, found.end)
