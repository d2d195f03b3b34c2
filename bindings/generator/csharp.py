#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes the raw layer of the C# binding from the public header, and the plain getters and setters of its classes.

    csharp.py [--check] [--header FILE] [--root DIR]     writes bindings/csharp/src/Generated
"""
import re
import sys

import csharp_docs
import csharp_names
import output
import plain
from csharp_names import camel, pascal, type_name

OUT = "bindings/csharp/src/Generated"
HEAD = """// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
"""
HAND = {"lr_batch_get_view", "lr_world_set_uniform_wind"}  # have hand-written wrappers
INIT_DOC = "Fills a struct with its initial values; <c>{}.Create()</c> does it with the right size."


def sentence(text):
    """Makes a sentence of a text that begins with a word, not with a unit."""
    return text[:1].upper() + text[1:] + ("" if text[-1:] in ".:" else ".") if text else text


def file_name(section):
    """The file of a section of the header: its title without the explanation."""
    return pascal(re.split(r"[:.]", section)[0].replace(" ", "_"))


class Generator:
    def __init__(self, model):
        self.model = model
        self.names = csharp_names.Names(model)
        self.docs = csharp_docs.Docs(self.names)

    # Types

    def type(self, type_, enum=None):
        """The type of a parameter, or of a field that is not an array."""
        kind = type_["kind"]
        if kind == "scalar":
            return enum or csharp_names.SCALARS[type_["name"]]
        if kind in ("handle", "struct"):
            return type_name(type_["name"])
        if kind in ("callback", "function"):
            return "IntPtr"
        if kind == "pointer":
            to = type_["to"]
            return "IntPtr" if to["kind"] == "opaque" else self.type(to, enum) + "*"
        raise ValueError(f"no rule for the type {type_}")

    def parameter_type(self, function, parameter):
        # The library only passes these pointers back to the caller.
        if parameter["name"] in ("user", "task", "token"):
            return "IntPtr"
        return self.type(parameter["type"], self.names.enum(parameter["type"]))

    # Documentation

    def summary(self, text, indent):
        return self.docs.element("summary", text, indent)

    def field_doc(self, struct, field, enum):
        name, text = field["name"], field["doc"] or field["about"]
        if name == "struct_size":
            return "Size of the struct in bytes, set by `Create`." + (f" {text[:1].upper()}{text[1:]}." if text else "")
        if name.startswith("reserved"):
            return "0."
        if enum:
            text = re.sub(r"^(bits )?LR_[A-Z_]+?_\*(?:, LR_[A-Z_]+?_\*)*", lambda m: f"`@{enum}`", text)
        return text or name.replace("_", " ").capitalize() + "."

    # Enums and limits

    def enum(self, entry):
        name, base, flags, about = entry
        self.docs.local = {}
        members = self.names.members[name]
        text = about or next((c["about"] for _, c in members if c["about"]), "") or f"{name}."
        lines = self.summary(text, "    ")
        if flags:
            lines.append("    [Flags]")
        lines += [f"    public enum {name} : {base}", "    {"]
        if flags and not any(c["value"] == 0 for _, c in members):
            lines += self.summary("No bit.", "        ") + ["        None = 0,"]
        for member, constant in members:
            text = sentence(constant["doc"]) or f"The header's `@@{constant['name']}`."
            lines += self.summary(text, "        ") + [f"        {member} = {constant['value']},"]
        return lines + ["    }"]

    def limits(self):
        version = self.model["version"]
        lines = self.summary("Version of the header behind these sources, and limits of the library.", "    ")
        lines += ["    public static class Limits", "    {"]
        for part, value in version.items():
            lines += self.summary(f"Version of the header: {part}.", "        ")
            lines.append(f"        public const uint Version{part.capitalize()} = {value};")
        for member, constant in self.names.limits:
            type_ = csharp_names.SCALARS[constant["scalar"]]
            value = f"{constant['value']:g}f" if type_ == "float" else f"{constant['value']}u"
            lines += self.summary(constant["doc"] or f"{member}.", "        ")
            lines.append(f"        public const {type_} {member} = {value};")
        return lines + ["    }"]

    # Handles and callbacks

    def handle(self, handle):
        name, scalar = type_name(handle["name"]), csharp_names.SCALARS[handle["of"]]
        lines = self.summary(sentence(handle["doc"]), "    ")
        lines += ["    [StructLayout(LayoutKind.Sequential)]", f"    public readonly struct {name} : IEquatable<{name}>", "    {"]
        body = f"""/// <summary>The number in the C API; 0 means none.</summary>
public readonly {scalar} Value;
/// <summary>A handle from its number.</summary>
public {name}({scalar} value) {{ Value = value; }}
/// <summary>Whether this is no handle. The handle of a destroyed object is not null: calls refuse it as stale.</summary>
public bool IsNull {{ get {{ return Value == 0; }} }}
/// <inheritdoc/>
public bool Equals({name} other) {{ return Value == other.Value; }}
/// <inheritdoc/>
public override bool Equals(object other) {{ return other is {name} && Equals(({name})other); }}
/// <inheritdoc/>
public override int GetHashCode() {{ return Value.GetHashCode(); }}
/// <inheritdoc/>
public override string ToString() {{ return "{name}(0x" + Value.ToString("x") + ")"; }}
/// <summary>Whether the handles are equal.</summary>
public static bool operator ==({name} left, {name} right) {{ return left.Value == right.Value; }}
/// <summary>Whether the handles differ.</summary>
public static bool operator !=({name} left, {name} right) {{ return left.Value != right.Value; }}"""
        return lines + ["        " + line for line in body.split("\n")] + ["    }"]

    def delegate(self, name, function, doc, owner):
        self.docs.local = {}
        parameters = []
        for parameter in function["parameters"]:
            void = parameter["type"]["kind"] == "pointer" and parameter["type"]["to"].get("name") == "void"
            type_ = "IntPtr" if void else self.parameter_type(owner, parameter)
            parameters.append(f"{type_} {camel(parameter['name'])}")
        result = self.type(function["result"])
        result = "IntPtr" if result == "void*" else result
        lines = self.summary(doc, "    ") + ["    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]"]
        return lines + [f"    public unsafe delegate {result} {name}({', '.join(parameters)});"]

    # Structs

    def fields(self, struct):
        """(declaration, name, doc, offset, bytes) of every field in C#."""
        for field in struct["fields"]:
            name, type_, at = pascal(field["name"]), field["type"], field["offset"]
            enum = self.names.enum(field["type"])
            doc = self.field_doc(struct, field, enum)
            if name == type_name(struct["name"]):
                raise ValueError(f"{struct['name']}.{field['name']}: has the name of its type, which C# forbids")
            if type_.get("to", {}).get("name") == "void":
                yield f"IntPtr {name}", name, doc, at, field["size"]
            elif type_["kind"] != "array":
                if type_["kind"] == "callback":
                    doc += f" A function pointer of a `{type_['name']}`."
                elif type_["kind"] == "function":
                    delegate = type_name(struct["name"]) + pascal(field["name"]) + "Fn"
                    doc = f"Function pointer of a `@{delegate}`."
                yield f"{self.type(type_, enum)} {name}", name, doc, at, field["size"]
            else:
                yield from self.array(name, type_, doc, at)

    def array(self, name, type_, doc, at):
        of, count = type_["of"], type_["count"]
        if of["kind"] in ("pointer", "struct"):
            size = self.size(of)
            for i, suffix in enumerate(csharp_names.suffixes(count) if of["kind"] == "pointer" else map(str, range(count))):
                yield f"{self.type(of)} {name}{suffix}", name + suffix, f"{doc.rstrip('.')}. Element {i} of {count}.", at + i * size, size
        elif (of["name"], count) in csharp_names.VECTORS:
            yield f"{csharp_names.VECTORS[of['name'], count]} {name}", name, doc, at, self.size(of) * count
        else:
            yield f"fixed {self.type(of)} {name}[{count}]", name, doc, at, self.size(of) * count

    def size(self, type_):
        if type_["kind"] == "struct":
            return self.names.structs[type_["name"]]["size"]
        return {"char": 1, "u32": 4, "i32": 4, "f32": 4}.get(type_.get("name"), 8)

    def struct(self, struct):
        name = type_name(struct["name"])
        self.docs.local = {f["name"]: f"<c>{pascal(f['name'])}</c>" for f in struct["fields"]}
        lines = self.summary(struct["doc"] or f"The header's `struct {struct['name']}`.", "    ")
        lines += ["    [StructLayout(LayoutKind.Sequential)]", f"    public unsafe partial struct {name}", "    {"]
        for declaration, _, doc, *_ in self.fields(struct):
            lines += self.summary(doc, "        ") + [f"        public {declaration};"]
        for field in struct["fields"]:
            if field["type"]["kind"] == "array" and field["type"]["of"]["kind"] == "struct":
                lines += [""] + self.element(field)
        if struct["init"]:
            lines += ["", "        /// <summary>A struct with its initial values and its size.</summary>",
                      f"        public static {name} Create()", "        {", f"            var value = default({name});",
                      "            LangevinLibrary.EnsureLoaded();",
                      f'            LangevinException.Check(Native.{struct["init"]}(&value, (uint)sizeof({name})), "{struct["init"]}");',
                      "            return value;", "        }"]
        return lines + ["    }"]

    def element(self, field):
        name, type_, count = pascal(field["name"]), type_name(field["type"]["of"]["name"]), field["type"]["count"]
        return ["        " + line for line in f"""/// <summary>Element <paramref name="index"/> of the {count}.</summary>
public ref {type_} {name}(int index)
{{
    if ((uint)index >= {count}u) throw new ArgumentOutOfRangeException("index");
    fixed ({type_}* first = &{name}0) return ref first[index];
}}""".split("\n")]

    # Functions

    def function(self, function):
        name = function["name"]
        self.docs.local = {p["name"]: f'<paramref name="{camel(p["name"]).lstrip("@")}"/>' for p in function["parameters"]}
        text = function["doc"] or function["returns"]
        if name.endswith("_init") and not function["doc"]:
            summary = ["        /// <summary>" + INIT_DOC.format(type_name(name.removesuffix("_init"))) + "</summary>"]
        else:
            summary = self.summary("\n\n".join(filter(None, (text, function["threads"]))), "        ")
        lines = summary
        for parameter in function["parameters"]:
            doc = parameter["doc"] or parameter["name"].replace("_", " ")
            lines += self.docs.element(f'param name="{camel(parameter["name"]).lstrip("@")}"', doc, "        ")
        result = self.type(function["result"])
        if function["returns"] and result == "Status":
            lines += self.docs.element("returns", function["returns"], "        ")
        parameters = ", ".join(f"{self.parameter_type(name, p)} {camel(p['name'])}" for p in function["parameters"])
        lines.append("        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]")
        return lines + [f"        public static extern {result} {name}({parameters});"]

    # Plain getters and setters

    def plain_parameter(self, function, parameter):
        """The type and the expression to pass."""
        name, type_ = camel(parameter["name"]), self.parameter_type(function["name"], parameter)
        if parameter["name"] in ("count", "capacity") and type_ == "uint":
            return "int", "number"
        return ("bool", f"{name} ? 1 : 0") if parameter["name"] == "enabled" else (type_, name)

    def plain_body(self, call):
        """The type and the statements of a getter."""
        [value], name = call["values"], call["function"]["name"]
        type_ = self.parameter_type(name, value).removesuffix("*")
        init = f" = new {type_} {{ StructSize = (uint)sizeof({type_}) }}" if call["struct"] else ""
        lines = [f"{type_} value{init};", f'Leave(Native.{name}({self.plain_arguments(call, "Enter()")}, &value), "{name}");']
        return ("bool", [*lines, "return value != 0;"]) if value["name"] == "enabled" else (type_, [*lines, "return value;"])

    def plain_arguments(self, call, enter):
        handle = {"world": "", "batch": ", _id"}.get(call["owner"], f", {call['owner']}")
        return enter + handle

    def plain_set(self, call, *values):
        name = call["function"]["name"]
        return f'Leave(Native.{name}({", ".join([self.plain_arguments(call, "EnterChange()"), *values])}), "{name}");'

    def plain_members(self, call, other):
        """The member for a call and its counterpart; nothing for a setter that its getter already covers."""
        function, name = call["function"], pascal(call["name"])
        handle = [] if call["owner"] in ("world", "batch") else [f"{type_name('lr_' + call['owner'])} {call['owner']}"]
        self.docs.local = {p["name"]: f"<c>{camel(p['name'])}</c>" for p in function["parameters"]}
        number = not call["struct"] and len(call["values"]) == 1
        if number and other and call["verb"] == "set":
            return
        lines = self.summary(plain.summary((other if number and other else call)["function"]) + f" `{function['name']}`", "")
        said = [line for p in call["values"] for line in self.docs.element(f'param name="{camel(p["name"]).lstrip("@")}"', p["doc"], "") if p["doc"]]
        if call["verb"] == "get":
            type_, body = self.plain_body(call)
            if handle or call["struct"] and (call["owner"] == "batch" or call["pointers"]):
                yield lines + [f"public {type_} Get{name}({', '.join(handle)})", "{", *("    " + line for line in body), "}"]
                return
            setter = []
            if other:
                [value] = other["values"]
                setter = [f"    set {{ {self.plain_set(other, 'value ? 1 : 0' if value['name'] == 'enabled' else 'value')} }}"]
            yield lines + [f"public {type_} {name}", "{", "    get", "    {", *("        " + line for line in body), "    }", *setter, "}"]
            return
        types = [self.plain_parameter(function, p) for p in call["values"]]
        if call["struct"]:
            types = [(type_name(call["struct"]), "&" + camel(call["values"][0]["name"]))]
        parameters = ", ".join(handle + [f"{type_} {camel(p['name'])}" for (type_, _), p in zip(types, call["values"])])
        if not call["struct"]:
            lines += said
        # Count first: it can throw, and Enter() must come after that (see World.Enter).
        counts = [f"    uint number = Counts.Of({camel(p['name'])});" for (_, given), p in zip(types, call["values"]) if given == "number"]
        yield lines + [f"public void Set{name}({parameters})", "{", *counts, "    " + self.plain_set(call, *(given for _, given in types)), "}"]
        if function["null"]:
            yield [f'/// <summary>Undoes <see cref="Set{name}({type_name(call["struct"])})"/>.</summary>',
                   f"public void {function['null'].capitalize()}{name}({', '.join(handle)})", "{", "    " + self.plain_set(call, "null"), "}"]

    def plain_files(self):
        calls = list(plain.calls(self.model, HAND))
        for class_, owners in (("World", ("world", "body", "collider")), ("Batch", ("batch",))):
            members = [member for call in calls if call["owner"] in owners for member in self.plain_members(call, plain.partner(calls, call))]
            body = "\n\n".join("\n".join("        " + line for line in member) for member in members)
            yield f"{class_}.Plain.cs", (f"{HEAD}namespace LangevinRigid\n{{\n    public sealed unsafe partial class {class_}\n    {{\n{body}\n"
                                        "    }\n}\n")

    def wind_sources(self):
        """Methods of World for each kind of wind source, as AddGusts, UpdateGusts and GetGusts."""
        blocks = []
        for function in self.model["functions"]:
            match = re.fullmatch(r"lr_world_add_(\w+)", function["name"])
            if not match:
                continue
            name, method, desc = match.group(1), pascal(match.group(1)), type_name(function["parameters"][1]["type"]["to"]["name"])
            summary = re.match(r"Adds ([^.:]+)", function["doc"]).group(1)
            blocks.append(f"""/// <summary>Adds {summary}.</summary>
public WindSourceId Add{method}({desc} desc)
{{
    WindSourceId source;
    LeaveNew(Native.lr_world_add_{name}(EnterChange(), &desc, &source), "lr_world_add_{name}");
    return source;
}}

/// <summary>Replaces all values of {summary}.</summary>
public void Update{method}(WindSourceId source, {desc} desc)
{{
    Leave(Native.lr_world_update_{name}(EnterChange(), source, &desc), "lr_world_update_{name}");
}}

/// <summary>Reads {summary} as last set.</summary>
public {desc} Get{method}(WindSourceId source)
{{
    {desc} desc = {desc}.Create();
    Leave(Native.lr_world_get_{name}(Enter(), source, &desc), "lr_world_get_{name}");
    return desc;
}}""")
        body = "\n".join("        " + line if line else line for line in "\n\n".join(blocks).split("\n"))
        return f"{HEAD}namespace LangevinRigid\n{{\n    public sealed unsafe partial class World\n    {{\n{body}\n    }}\n}}\n"

    # Files

    def types_of(self, section):
        blocks = []
        for entry in self.names.enums:
            if self.names.members[entry[0]][0][1]["section"] == section:
                blocks.append(self.enum(entry))
        if any(constant["section"] == section for _, constant in self.names.limits) and section == self.sections()[0]:
            blocks.append(self.limits())
        for handle in self.model["handles"]:
            if handle["section"] == section and csharp_names.HANDLES[handle["name"]].endswith("Id"):
                blocks.append(self.handle(handle))
        for callback in self.model["callbacks"]:
            if callback["section"] == section:
                blocks.append(self.delegate(type_name(callback["name"]), callback, callback["doc"], callback["name"]))
        for struct in self.model["structs"]:
            if struct["section"] != section:
                continue
            for field in struct["fields"]:
                if field["type"]["kind"] == "function":
                    owner = type_name(struct["name"])
                    doc = f"The function type of `{pascal(field['name'])}` in a `{struct['name']}`."
                    blocks.append(self.delegate(owner + pascal(field["name"]) + "Fn", field["type"], doc, struct["name"]))
            blocks.append(self.struct(struct))
        return blocks

    def sections(self):
        seen = {}
        for kind in ("constants", "structs", "functions"):
            for thing in self.model[kind]:
                seen.setdefault(thing["section"], None)
        return list(seen)

    def files(self):
        """{file name: text}"""
        out = dict(self.plain_files())
        for section in self.sections():
            name, using = file_name(section), "using System;\nusing System.Runtime.InteropServices;\n\n"
            types = self.types_of(section)
            if types:
                body = "\n\n".join("\n".join(block) for block in types)
                out[f"{name}.cs"] = f"{HEAD}{using}namespace LangevinRigid\n{{\n{body}\n}}\n"
            functions = [self.function(f) for f in self.model["functions"] if f["section"] == section]
            if functions:
                body = "\n\n".join("\n".join(block) for block in functions)
                out[f"Native.{name}.cs"] = (f"{HEAD}{using}namespace LangevinRigid\n{{\n    public static unsafe partial class Native\n"
                                            f"    {{\n{body}\n    }}\n}}\n")
        out["World.WindSources.cs"] = self.wind_sources()
        return out


def main():
    return output.run(__doc__, lambda model: {f"{OUT}/{name}": text for name, text in Generator(model).files().items()}, owned=f"{OUT}/*.cs")


if __name__ == "__main__":
    sys.exit(not main())
