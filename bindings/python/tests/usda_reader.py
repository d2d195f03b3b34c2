# SPDX-License-Identifier: MIT
"""Reads the part of USD's text format that the exporter writes: prims, typed attributes, time samples, relationships, metadata.
Refuses everything else, and values that do not match their attribute's type."""
import re

TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|<[^>]*>|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|[A-Za-z_][\w:.]*|[()\[\]{}=,]|\S')
FLOATS = {"float": 1, "double": 1, "half": 1, "float3": 3, "point3f": 3, "vector3f": 3, "color3f": 3, "texCoord2f": 2, "quath": 4}
INTEGERS = {"int": (-2**31, 2**31 - 1), "int64": (-2**63, 2**63 - 1)}


class Prim:
    def __init__(self, kind, name):
        self.kind, self.name = kind, name
        self.attributes, self.relationships, self.children = {}, {}, {}

    def at(self, path):
        prim = self
        for name in path.strip("/").split("/"):
            prim = prim.children[name]
        return prim


class Reader:
    def __init__(self, text):
        if not text.startswith("#usda 1.0\n"):
            raise ValueError("no header")
        self.tokens = TOKEN.findall(text.split("\n", 1)[1])
        self.index = 0

    def next(self, wanted=None):
        token = self.tokens[self.index] if self.index < len(self.tokens) else ""
        if wanted is not None and token != wanted:
            raise ValueError(f"expected {wanted}, not {token!r} after {' '.join(self.tokens[max(self.index - 8, 0):self.index])}")
        self.index += 1
        return token

    def peek(self):
        return self.tokens[self.index] if self.index < len(self.tokens) else ""

    def stage(self):
        root = Prim("", "")
        root.metadata = self.metadata() if self.peek() == "(" else {}
        while self.peek():
            self.prim(root)
        return root

    def metadata(self):
        found = {}
        self.next("(")
        while self.peek() != ")":
            name = self.next()
            self.next("=")
            found[name] = self.scalar(self.next())
        self.next(")")
        return found

    @staticmethod
    def scalar(token):
        if token.startswith('"'):
            return token[1:-1]
        return float(token) if re.search(r"[.eE]", token) else int(token)

    def prim(self, parent):
        self.next("def")
        kind, name = self.next(), self.next()
        if not re.match(r"[A-Z]\w*$", kind) or not re.match(r'"[A-Za-z_]\w*"$', name) or name[1:-1] in parent.children:
            raise ValueError(f"prim {kind} {name}")
        prim = parent.children[name[1:-1]] = Prim(kind, name[1:-1])
        self.next("{")
        while self.peek() != "}":
            if self.peek() == "def":
                self.prim(prim)
            elif self.peek() == "rel":
                self.next()
                of = self.next()
                self.next("=")
                target = self.next()
                if not re.match(r"</[\w/]+>$", target):
                    raise ValueError(f"target {target}")
                prim.relationships[of] = target[1:-1]
            else:
                self.attribute(prim)
        self.next("}")

    def attribute(self, prim):
        kind = self.next()
        uniform = kind == "uniform"
        kind = self.next() if uniform else kind
        array = self.peek() == "["
        if array:
            self.next(), self.next("]")
        name = self.next()
        sampled = name.endswith(".timeSamples")
        name = name[:-len(".timeSamples")] if sampled else name
        if name in prim.attributes or uniform and sampled:
            raise ValueError(f"attribute {name}")
        self.next("=")
        if sampled:
            value, last = {}, None
            self.next("{")
            while self.peek() != "}":
                time = self.scalar(self.next())
                if last is not None and time <= last:
                    raise ValueError("times out of order")
                last = time
                self.next(":") if self.peek() == ":" else None
                value[time] = self.value(kind, array)
                if self.peek() == ",":
                    self.next()
            self.next("}")
        else:
            value = self.value(kind, array)
        details = self.metadata() if self.peek() == "(" else {}
        prim.attributes[name] = {"type": kind + ("[]" if array else ""), "value": value, "sampled": sampled, **details}

    def value(self, kind, array):
        if not array:
            return self.item(kind)
        values = []
        self.next("[")
        while self.peek() != "]":
            values.append(self.item(kind))
            if self.peek() != "]":
                self.next(",")
        self.next("]")
        return values

    def item(self, kind):
        if kind == "token":
            token = self.next()
            if not token.startswith('"'):
                raise ValueError(f"token {token}")
            return token[1:-1]
        if kind == "bool":
            return {"0": False, "1": True}[self.next()]
        if kind in INTEGERS:
            token = self.next()
            low, high = INTEGERS[kind]
            if not re.match(r"-?\d+$", token) or not low <= int(token) <= high:
                raise ValueError(f"{kind} {token}")
            return int(token)
        width = FLOATS[kind]
        if width == 1:
            return float(self.next())
        parts = []
        self.next("(")
        for at in range(width):
            parts.append(float(self.next()))
            self.next(")" if at == width - 1 else ",")
        return parts


def read(path):
    with open(path, encoding="utf-8") as file:
        return Reader(file.read()).stage()
