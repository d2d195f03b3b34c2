#!/usr/bin/env python3
"""Turns the header's plain comments into Doxygen's form. Usage: doxygen_filter.py FILE, writes to standard output.

The header keeps plain comments for editors. Comments before a declaration and after a member become its documentation, banners
become groups, "name: ..." of a parameter becomes @param, the list of statuses @returns. The baker's header, in C++, has line
comments.
"""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bindings" / "generator"))
from header_comments import COMMON_PARAMETERS, STATUSES_START, parameter_start, text_of  # noqa: E402

COMMENT = re.compile(r"/\*.*?\*/", re.S)
BANNER = re.compile(r"^/\* -+ \*/\n/\* (.*?)\s*\*/\n(?:/\* -+ \*/\n)?", re.M)


def escaped(text):
    return re.sub(r"([@\\<>#&%])", r"\\\1", text)


def parameters(declaration):
    """Names in a function's declaration, in order."""
    inside = declaration[declaration.find("(") + 1:declaration.rfind(")")]
    inside = re.sub(r"\([^()]*\)\s*\([^()]*\)", "", inside)
    return [m.group(1) for part in inside.split(",") if (m := re.search(r"(\w+)\s*(?:\[\w*\])?\s*$", part))]


def sections(text, names):
    """@param for parameters, @returns for statuses."""
    if names:
        text = re.sub(parameter_start(names), lambda m: "\n@param " + re.sub(r", | and ", ",", m.group(1)) + " ", text)
        text = re.sub(STATUSES_START, r"\n@returns \1", text, count=1)
        text = re.sub(r"(?<=[.\)])\s+(Any thread\.)", r"\n@par Threads\n\1", text)
    return text


def indented_as_code(lines):
    """Keeps the layout of indented lists."""
    out, code = [], False
    for line in lines:
        starts = line.startswith("  ") and not line.startswith("  - ")
        if starts != code:
            out.append("@verbatim" if starts else "@endverbatim")
            code = starts
        out.append(line if code else escaped(line))
    if code:
        out.append("@endverbatim")
    return out


def documented(source):
    out, at, group = [], 0, 0
    for match in COMMENT.finditer(source):
        before, comment = source[at:match.start()], match.group()
        out.append(before)
        at = match.end()
        line_start = source.rfind("\n", 0, match.start()) + 1
        code_before = source[line_start:match.start()].strip()
        if comment.startswith("/**"):  # from a banner
            out.append(comment)
            continue
        lines = text_of(comment)
        if code_before:
            words = escaped(" ".join(line.strip() for line in lines).strip())
            directive = code_before.startswith("#") and not code_before.startswith("#define")
            out.append(comment if directive else f"/**< {words} */")
            continue
        declaration = source[at:]
        declaration = declaration[:declaration.find(";") + 1]
        is_function = declaration.lstrip().startswith(("LR_API", "typedef void (", "typedef float (")) or "(*" in declaration[:80]
        names = parameters(declaration) if is_function else []
        body = sections("\n".join(indented_as_code(lines)), names)
        if "@param" in body:
            said = set(re.split(r"[,\s]+", " ".join(re.findall(r"@param ([\w,]+)", body))))
            more = "".join(f"@param {name} {COMMON_PARAMETERS[name]}\n" for name in names if name not in said and name in COMMON_PARAMETERS)
            at_end = body.find("@returns")
            body = body[:at_end] + more + body[at_end:] if at_end >= 0 else body + "\n" + more
        newlines = comment.count("\n")
        out.append("/**\n" + body + "\n*/" if newlines or names else f"/** {body.strip()} */")
    out.append(source[at:])
    return "".join(out)


def line_comments(source):
    """The baker's header, in C++: `//` before a declaration and after a member."""
    out = []
    for line in source.split("\n"):
        match = re.match(r"^(.*?)//\s?(.*)$", line)
        if match and not match.group(1).rstrip().endswith(":"):
            trailing = match.group(1).strip()
            line = match.group(1) + ("///< " if trailing else "/// ") + escaped(match.group(2))
        out.append(line)
    return "\n".join(out)


def grouped(source):
    """Turns banners into groups; each ends at the next banner."""
    count = 0

    def group(match):
        nonlocal count
        count += 1
        end = "/** @} */\n" if count > 1 else ""
        title = match.group(1).strip().rstrip(".")
        return f"{end}/** @defgroup {re.sub('[^a-z]+', '_', title.lower())} {escaped(title)}\n@{{ */\n"

    source = BANNER.sub(group, source)
    if count:
        cut = source.rfind("#ifdef __cplusplus")
        source = source[:cut] + "/** @} */\n" + source[cut:]
    return source


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        source = file.read()
    heading = COMMENT.match(source)
    front = ""
    if heading:
        lines = [line for line in text_of(heading.group()) if "SPDX" not in line]
        front = "/** @file\n@verbatim\n" + "\n".join(lines).strip("\n") + "\n@endverbatim\n*/\n"
        source = source[heading.end():]
    plus = sys.argv[1].endswith(".hpp")
    sys.stdout.write(front + (line_comments(source) if plus else documented(grouped(source))))


if __name__ == "__main__":
    main()
