#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A small stand-in for Unreal's header tool. It writes NAME.generated.h for each header with UCLASS or USTRUCT, and the engine's
headers of headers.txt, into a folder; and it refuses the same faults as the real tool.

    header_tool.py OUT_DIR HEADER...
"""
import re
import sys
from pathlib import Path

BLUEPRINT_TYPES = {
    "bool", "uint8", "int32", "int64", "float", "double", "FName", "FString", "FText", "FVector", "FVector2D", "FRotator",
    "FQuat", "FTransform", "FLinearColor", "void",
}
problems = []


def complain(path: Path, line: int, text: str) -> None:
    problems.append(f"{path}:{line}: {text}")


def plain_type(text: str, known: set) -> bool:
    """Whether Blueprints support a type."""
    text = re.sub(r"\b(const|class|struct)\b", "", text).replace("&", "").strip()
    container = re.fullmatch(r"(TArray|TSet|TObjectPtr|TSubclassOf|TSoftObjectPtr|TWeakObjectPtr)<(.*)>", text)
    if container:
        return plain_type(container.group(2), known)
    if text.endswith("*"):
        return re.fullmatch(r"[UA][A-Z]\w*", text[:-1].strip()) is not None
    return text in BLUEPRINT_TYPES or text in known or re.fullmatch(r"[UA][A-Z]\w*", text) is not None


def split_parameters(text: str) -> list:
    parts, depth, part = [], 0, ""
    for c in text:
        depth += c in "<(" and 1 or (c in ">)" and -1 or 0)
        if c == "," and depth == 0:
            parts.append(part)
            part = ""
        else:
            part += c
    return [p for p in parts + [part] if p.strip()]


def check_function(path: Path, line: int, text: str, known: set) -> None:
    match = re.match(r"\s*(?:virtual\s+|static\s+)?(.+?[\s&*])(\w+)\((.*?)\)\s*(?:const)?", text, re.S)
    if not match:
        return complain(path, line, "UFUNCTION without a function")
    returned, name, parameters = match.groups()
    types = [returned] + [re.sub(r"=.*", "", p, flags=re.S).strip().rsplit(None, 1)[0] +
                          ("&" if "&" in p else "") + ("*" if "*" in p else "") for p in split_parameters(parameters)]
    for kind in types:
        kind = kind.replace("**", "*")
        if not plain_type(kind, known):
            complain(path, line, f"{name}: type '{kind.strip()}' is not supported by blueprint")


def after_macro(lines: list, number: int) -> tuple:
    """The text in brackets of a macro that begins on a line (from 1), and the index of the next line."""
    depth, text = 0, ""
    for index in range(number - 1, len(lines)):
        for c in lines[index]:
            depth += (c == "(") - (c == ")")
            text += c
            if c == ")" and depth == 0:
                return text, index + 1
    return text, len(lines)


def process(path: Path, out: Path, known: set) -> None:
    text = path.read_text()
    lines = text.split("\n")
    generated = path.stem + ".generated.h"
    includes = [(i, l) for i, l in enumerate(lines) if l.startswith("#include")]
    if not includes or includes[-1][1] != f'#include "{generated}"':
        complain(path, includes[-1][0] + 1 if includes else 1, f'#include "{generated}" must be the last include')
    file_id = "FID_" + re.sub(r"\W", "_", path.stem)
    result = ["#pragma once", "#undef CURRENT_FILE_ID", f"#define CURRENT_FILE_ID {file_id}"]
    current = None
    for number, line in enumerate(lines, 1):
        kind = re.match(r"\s*(UCLASS|USTRUCT)\(", line)
        if kind:
            head = "\n".join(lines[number - 1:number + 6])
            match = re.search(r"^(class|struct)\s+(?:\w+_API\s+)?(\w+)\s*(?::\s*public\s+(\w+))?", head, re.M)
            if not match:
                complain(path, number, "no class after " + kind.group(1))
                continue
            current = match
            if match.group(1) == "class" and match.group(2)[0] not in "UA":
                complain(path, number, f"{match.group(2)}: class names begin with U or A")
            if match.group(1) == "struct" and match.group(2)[0] != "F":
                complain(path, number, f"{match.group(2)}: struct names begin with F")
        if "GENERATED_BODY()" in line:
            if current is None:
                complain(path, number, "GENERATED_BODY outside of a UCLASS or USTRUCT")
                continue
            form, name, base = current.groups()
            macro = f"{file_id}_{number}_GENERATED_BODY"
            result.append(f"#define {macro} SHIM_OBJECT({name}, {base}) private:" if form == "class" else
                          f"#define {macro}")
            current = None
        if re.match(r"\s*UFUNCTION\(", line):
            _, next_line = after_macro(lines, number)
            check_function(path, number, " ".join(lines[next_line:next_line + 6]).split(";")[0], known)
        if re.match(r"\s*UPROPERTY\(", line):
            line, next_line = after_macro(lines, number)
            declared = lines[next_line].strip().rstrip(";").split("=")[0].strip()
            kind = declared.rsplit(None, 1)[0]
            if "Blueprint" in line and "BlueprintAssignable" not in line and not plain_type(kind, known):
                complain(path, number + 1, f"type '{kind}' is not supported by blueprint")
            if re.search(r"\b(u?int16|uint32|uint64|size_t)\b", kind) and "Blueprint" in line:
                complain(path, number + 1, f"type '{kind}' is not supported by blueprint")
            if "Category" not in line and ("Edit" in line or "Visible" in line or "Blueprint" in line):
                complain(path, number, "an exposed property needs a Category")
    (out / generated).write_text("\n".join(result) + "\n")


def main() -> None:
    out = Path(sys.argv[1])
    here = Path(__file__).resolve().parent
    out.mkdir(parents=True, exist_ok=True)
    for line in (here / "headers.txt").read_text().split("\n"):
        if line and not line.startswith("#"):
            name, target = line.split()
            (out / name).parent.mkdir(parents=True, exist_ok=True)
            (out / name).write_text(f'#pragma once\n#include "{here / target}"\n')
    headers = [Path(p) for p in sys.argv[2:]]
    known = set()
    for path in headers:
        known |= set(re.findall(r"^(?:enum class|struct)\s+(?:\w+_API\s+)?([EF]\w+)", path.read_text(), re.M))
    for path in headers:
        if "GENERATED_BODY()" in path.read_text():
            process(path, out, known)
        elif ".generated.h" in path.read_text() and "UENUM" not in path.read_text():
            complain(path, 1, "includes a generated header, but has nothing to generate")
    if problems:
        sys.exit("\n".join(problems))


if __name__ == "__main__":
    main()
