# SPDX-License-Identifier: MIT
"""Reads native libraries: format, machine, dependencies, exports; and writes an import library for a DLL.

MinGW's import libraries are not in the short format that Microsoft's linker needs for delay loading, so this writes one from
the DLL's exports (Microsoft PE and COFF specification, Archive and Import Library Format).
"""
import re
import struct
from dataclasses import dataclass, field
from pathlib import Path

SYSTEM = re.compile(
    r"^(lib(c|m|dl|pthread|rt|gcc_s|stdc\+\+|util)\.so\.\d+|ld-linux.*|"
    r"kernel32\.dll|user32\.dll|advapi32\.dll|shell32\.dll|ole32\.dll|ntdll\.dll|msvcrt\.dll|ucrtbase\.dll|api-ms-win-.*\.dll|"
    r"vcruntime140(_1)?\.dll|msvcp140(_\d)?\.dll)$", re.IGNORECASE)


@dataclass
class NativeFile:
    format: str
    machine: str
    soname: str = ""
    needed: list = field(default_factory=list)


def is_system(name: str) -> bool:
    return bool(SYSTEM.match(name))


def text_at(data: bytes, offset: int) -> str:
    return data[offset:data.index(b"\0", offset)].decode()


def describe(path: Path) -> NativeFile:
    data = Path(path).read_bytes()
    if data[:4] == b"\x7fELF":
        return describe_elf(data)
    if data[:2] == b"MZ":
        return describe_pe(data)
    raise SystemExit(f"{path}: neither an ELF nor a PE file")


def describe_elf(data: bytes) -> NativeFile:
    if data[4] != 2 or data[5] != 1:
        return NativeFile("elf", "32 bit or big-endian")
    machine = {62: "x86_64", 183: "aarch64"}.get(struct.unpack_from("<H", data, 18)[0], "unknown")
    result = NativeFile("elf", machine)
    program, = struct.unpack_from("<Q", data, 32)
    size, count = struct.unpack_from("<HH", data, 54)
    headers = [struct.unpack_from("<IIQQQQQQ", data, program + i * size) for i in range(count)]
    loads = [(h[3], h[2], h[5]) for h in headers if h[0] == 1]

    def file_offset(address: int) -> int:
        return next(address - start + offset for start, offset, length in loads if start <= address < start + length)

    for kind, _, offset, _, _, length, _, _ in headers:
        if kind != 2:
            continue
        entries = [struct.unpack_from("<qQ", data, offset + i) for i in range(0, length, 16)]
        strings = file_offset(next(value for tag, value in entries if tag == 5))
        for tag, value in entries:
            if tag == 1:
                result.needed.append(text_at(data, strings + value))
            elif tag == 14:
                result.soname = text_at(data, strings + value)
    return result


class Pe:
    def __init__(self, data: bytes):
        self.data = data
        self.header, = struct.unpack_from("<I", data, 0x3C)
        self.machine, sections, _, _, _, optional, _ = struct.unpack_from("<HHIIIHH", data, self.header + 4)
        self.directories = self.header + 24 + 112
        table = self.header + 24 + optional
        self.sections = [struct.unpack_from("<IIII", data, table + 40 * i + 8) for i in range(sections)]

    def offset(self, address: int) -> int:
        for virtual_size, virtual, raw_size, raw in self.sections:
            if virtual <= address < virtual + max(virtual_size, raw_size):
                return address - virtual + raw
        raise SystemExit("a damaged PE file: an address outside of all sections")

    def directory(self, index: int) -> int:
        address, = struct.unpack_from("<I", self.data, self.directories + 8 * index)
        return self.offset(address) if address else 0


def describe_pe(data: bytes) -> NativeFile:
    pe = Pe(data)
    result = NativeFile("pe", {0x8664: "x86_64", 0xAA64: "aarch64"}.get(pe.machine, "unknown"))
    entry = pe.directory(1)
    while entry:
        name, = struct.unpack_from("<I", data, entry + 12)
        if not name:
            break
        result.needed.append(text_at(data, pe.offset(name)))
        entry += 20
    return result


def pe_exports(path: Path) -> list:
    """The DLL's public function names: lr_*."""
    pe = Pe(Path(path).read_bytes())
    table = pe.directory(0)
    if not table:
        raise SystemExit(f"{path} exports nothing")
    count, _, names = struct.unpack_from("<III", pe.data, table + 24)
    found = [text_at(pe.data, pe.offset(struct.unpack_from("<I", pe.data, pe.offset(names) + 4 * i)[0]))
             for i in range(count)]
    found = sorted(name for name in found if name.startswith("lr_"))
    if not found:
        raise SystemExit(f"{path} exports no lr_ function")
    return found


MACHINE = 0x8664
C_EXTERNAL, C_STATIC, C_SECTION = 2, 3, 104
IDATA = 0xC0000040  # initialised data, read, write; | alignment


def coff_object(sections: list, symbols: list) -> bytes:
    """sections: (name, data, relocations, flags); relocations: (offset, symbol index, type). symbols: (name, value,
    section, storage class)."""
    strings = bytearray(4)

    def name_field(name: str) -> bytes:
        raw = name.encode()
        if len(raw) <= 8:
            return raw.ljust(8, b"\0")
        at = len(strings)
        strings.extend(raw + b"\0")
        return struct.pack("<II", 0, at)

    head, body = bytearray(), bytearray()
    start = 20 + 40 * len(sections)
    for name, data, relocations, flags in sections:
        raw_at = start + len(body)
        body += data
        relocations_at = start + len(body) if relocations else 0
        for offset, symbol, kind in relocations:
            body += struct.pack("<IIH", offset, symbol, kind)
        head += name.encode().ljust(8, b"\0") + struct.pack("<IIIIIIHHI", 0, 0, len(data), raw_at, relocations_at, 0,
                                                            len(relocations), 0, flags)
    table = b"".join(name_field(name) + struct.pack("<IhHBB", value, section, 0, storage, 0)
                     for name, value, section, storage in symbols)
    struct.pack_into("<I", strings, 0, len(strings))
    return (struct.pack("<HHIIIHH", MACHINE, len(sections), 0, start + len(body), len(symbols), 0, 0) + head + body +
            table + strings)


def import_library(dll: str, names: list) -> bytes:
    """A .lib in the short import format, which also lets link.exe and lld-link delay-load the DLL."""
    base = dll.rsplit(".", 1)[0]
    descriptor, null_descriptor = f"__IMPORT_DESCRIPTOR_{base}", "__NULL_IMPORT_DESCRIPTOR"
    null_thunk = f"\x7f{base}_NULL_THUNK_DATA"
    dll_name = dll.encode() + b"\0"
    dll_name += b"\0" * (len(dll_name) % 2)
    address = 3  # IMAGE_REL_AMD64_ADDR32NB
    members = [
        ([descriptor], coff_object(
            [(".idata$2", bytes(20), [(12, 2, address), (0, 3, address), (16, 4, address)], IDATA | 0x300000),
             (".idata$6", dll_name, [], IDATA | 0x200000)],
            [(descriptor, 0, 1, C_EXTERNAL), (".idata$2", IDATA, 1, C_SECTION), (".idata$6", 0, 2, C_STATIC),
             (".idata$4", IDATA, 0, C_SECTION), (".idata$5", IDATA, 0, C_SECTION), (null_descriptor, 0, 0, C_EXTERNAL),
             (null_thunk, 0, 0, C_EXTERNAL)])),
        ([null_descriptor], coff_object([(".idata$3", bytes(20), [], IDATA | 0x300000)],
                                        [(null_descriptor, 0, 1, C_EXTERNAL)])),
        ([null_thunk], coff_object([(".idata$5", bytes(8), [], IDATA | 0x400000),
                                    (".idata$4", bytes(8), [], IDATA | 0x400000)],
                                   [(null_thunk, 0, 1, C_EXTERNAL)])),
    ]
    for name in names:
        tail = name.encode() + b"\0" + dll.encode() + b"\0"
        kind = 0 | 1 << 2  # code, imported by its name
        members.append(([f"__imp_{name}", name],
                        struct.pack("<HHHHIIHH", 0, 0xFFFF, 0, MACHINE, 0, len(tail), 0, kind) + tail))

    def member(name: str, data: bytes) -> bytes:
        head = f"{name:<16}{0:<12}{'':<6}{'':<6}{0:<8}{len(data):<10}`\n".encode()
        return head + data + b"\n" * (len(data) % 2)

    symbols = [(symbol, i) for i, (defined, _) in enumerate(members) for symbol in defined]
    text_size = sum(len(symbol) + 1 for symbol, _ in symbols)
    first_size = 4 + 4 * len(symbols) + text_size
    second_size = 4 + 4 * len(members) + 4 + 2 * len(symbols) + text_size
    # Names over 15 characters are in the table of long names.
    name_field = dll + "/" if len(dll) < 16 else "/0"
    long_names = b"" if len(dll) < 16 else dll.encode() + b"\0"

    def padded(size: int) -> int:
        return 60 + size + size % 2

    at = 8 + padded(first_size) + padded(second_size) + (padded(len(long_names)) if long_names else 0)
    offsets = []
    for _, data in members:
        offsets.append(at)
        at += padded(len(data))
    first = struct.pack(">I", len(symbols)) + b"".join(struct.pack(">I", offsets[i]) for _, i in symbols)
    first += b"".join(symbol.encode("latin1") + b"\0" for symbol, _ in symbols)
    by_name = sorted(symbols, key=lambda entry: entry[0].encode("latin1"))
    second = struct.pack("<I", len(members)) + b"".join(struct.pack("<I", offset) for offset in offsets)
    second += struct.pack("<I", len(symbols)) + b"".join(struct.pack("<H", i + 1) for _, i in by_name)
    second += b"".join(symbol.encode("latin1") + b"\0" for symbol, _ in by_name)
    out = b"!<arch>\n" + member("/", first) + member("/", second)
    if long_names:
        out += member("//", long_names)
    return out + b"".join(member(name_field, data) for _, data in members)
