# SPDX-License-Identifier: MIT
"""A shared library with the functions of a header, empty, and debug information: what libabigail reads types from when the library
itself was built without. The compiler holds the library's own functions to the same header."""
import pathlib
import re
import shutil
import subprocess

from surface import api_model

ROOT = pathlib.Path(__file__).resolve().parents[2]
DECLARATION = re.compile(r"^LR_API ([^;]*?\)\s*);", re.S | re.M)


def build(header, folder, soname="liblangevin_rigid.so.0", extra="", version_script=ROOT / "src/api/exports.map"):
    """extra: C to be compiled along. Returns the library; beside it are its source and a copy of the header."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    headers = api_model.files_of(header)
    for file in headers:
        shutil.copyfile(file, folder / file.name)
    bodies = [m.group(1) + (" { }" if m.group(1).startswith("void ") else " { return 0; }")
              for file in headers for m in DECLARATION.finditer(file.read_text())]
    (folder / "stub.c").write_text(f'#include "{headers[-1].name}"\n' + "\n".join(bodies) + f"\n{extra}\n")
    subprocess.run(["cc", "-std=c99", "-g", "-O0", "-fPIC", "-shared", "-fvisibility=hidden", f"-ffile-prefix-map={folder}=.",
                    f"-Wl,-soname,{soname}", f"-Wl,--version-script={version_script}", "stub.c", "-o", "stub.so"],
                   check=True, cwd=folder)
    return folder / "stub.so"
