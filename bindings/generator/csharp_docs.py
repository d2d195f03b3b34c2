# SPDX-License-Identifier: MIT
"""Comments of the header as XML documentation, with references to their C# names."""
import re
import textwrap

import csharp_names

WIDTH = 120
REFERENCE = re.compile(r"`([^`]+)`|\b(lr_[a-z0-9_]+)(?:\.([a-z_0-9]+)|\(\))?|\b(LR_[A-Z0-9_]*[A-Z0-9])(_\*)?")


def escape(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


class Docs:
    def __init__(self, names):
        self.names = names
        self.local = {}  # meanings of names in backticks, in the present struct or function

    def see(self, name, field):
        """A reference to a type, a field or a function."""
        names = self.names
        if name in names.structs:
            type_ = csharp_names.type_name(name)
            fields = {f["name"]: f["type"] for f in names.structs[name]["fields"]}
            if field is None:
                return f'<see cref="{type_}"/>'
            if field in fields and not (fields[field]["kind"] == "array" and fields[field]["of"]["kind"] == "pointer"):
                return f'<see cref="{type_}.{csharp_names.pascal(field)}"/>'
            return f'<see cref="{type_}"/>.{csharp_names.pascal(field)}'
        if name in names.functions:
            return f'<see cref="Native.{name}"/>'
        if name in csharp_names.HANDLES or name in names.callbacks:
            return f'<see cref="{csharp_names.type_name(name)}"/>'
        return f"<c>{name}{'.' + field if field else ''}</c>"

    def constant(self, name, any_):
        names = self.names
        if name in names.enum_of and not any_:
            enum, member = names.enum_of[name]
            return f'<see cref="{enum}.{member}"/>'
        whole = name + ("_*" if any_ else "")
        if name.startswith("LR_ERROR"):
            return f"<c>Status.{csharp_names.pascal(name.removeprefix('LR_ERROR'))}*</c>"
        enum = names.prefixes.get(name + "_") if any_ else None
        return f'<see cref="{enum}"/>' if enum else f"<c>{whole}</c>"

    def inline(self, text):
        out, end = [], 0
        for match in REFERENCE.finditer(text):
            out.append(escape(text[end:match.start()]))
            code, name, field, constant, any_ = match.groups()
            if code is not None and code.startswith("@@"):
                out.append(f"<c>{code[2:]}</c>")
            elif code is not None and code.startswith("@"):
                out.append(f'<see cref="{code[1:]}"/>')
            elif code in self.local:
                out.append(self.local[code])
            elif code is not None and not re.fullmatch(r"lr_\w+(\.\w+)?|LR_\w+(\*)?", code):
                out.append(f"<c>{escape(code)}</c>")
            elif code is not None:
                out.append(self.inline(code))
            elif name:
                out.append(self.see(name, field))
            else:
                out.append(self.constant(constant, bool(any_)))
            end = match.end()
        out.append(escape(text[end:]))
        return "".join(out)

    def paragraphs(self, text):
        """Breaks a text into lines. Indented lines and lines that begin with a dash keep their breaks."""
        blocks, current = [], []
        for line in text.split("\n"):
            kept = line.startswith(("  ", " -"))
            if not line.strip():
                if current:
                    blocks.append(current)
                current = []
            elif kept and current and not current[0].startswith("  "):
                blocks.append(current)
                current = [line]
            else:
                current.append(line)
        if current:
            blocks.append(current)
        for block in blocks:
            if block[0].startswith("  "):
                yield "<code>", [escape(line) for line in block]
            else:
                yield "<para>", [self.inline(" ".join(" ".join(block).split()))]

    def element(self, tag, text, indent):
        """An element of documentation, as lines of a comment."""
        opening, closing = f"<{tag}>", f"</{tag.split()[0]}>"
        prefix = indent + "/// "
        blocks = list(self.paragraphs(text))
        if len(blocks) <= 1:
            words = opening + (blocks[0][1][0] if blocks and blocks[0][0] == "<para>" else "\n".join(sum((b for _, b in blocks), []))) + closing
            if blocks and blocks[0][0] == "<code>":
                return [prefix + line for line in words.split("\n")]
            return wrap(words, prefix)
        lines = [prefix + opening]
        for kind, block in blocks:
            if kind == "<code>":
                lines += [prefix + "<code>"] + [(prefix + line).rstrip() for line in block] + [prefix + "</code>"]
            else:
                lines += wrap(f"<para>{block[0]}</para>", prefix)
        return lines + [prefix + closing]


def wrap(text, prefix):
    # Never break at the space in `<see cref=`.
    text = text.replace('<see cref="', "<see\0cref=\"").replace('<param name="', "<param\0name=\"")
    text = text.replace('<paramref name="', "<paramref\0name=\"")
    lines = textwrap.wrap(text, WIDTH - len(prefix), break_long_words=False, break_on_hyphens=False)
    return [prefix + line.replace("\0", " ") for line in lines]
