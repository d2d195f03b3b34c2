#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the project's addresses into a package's description: a package.json of Unity or npm, or a .uplugin.

    LR_HOME=https://example.org/leaves LR_REPOSITORY=https://example.org/leaves.git addresses.py FILE

LR_HOME: where `dist` is published; LR_REPOSITORY: of the sources. Nothing is written of an address that is not set: no link is better than a
dead one.
"""
import json
import os
import re
import sys
from pathlib import Path


def write(file: Path) -> None:
    addresses = {name: os.environ.get(name, "").rstrip("/") for name in ("LR_HOME", "LR_REPOSITORY")}
    for name, address in addresses.items():
        if address and not re.fullmatch(r"https?://[^\s\"\\]+", address):
            raise ValueError(f"{name} is not an address: {address}")
    home, repository = addresses.values()
    pages = f"{home}/docs/docs/guide"
    text = file.read_text(encoding="utf-8")
    description = json.loads(text)
    if file.suffix == ".uplugin":
        urls = {"CreatedByURL": home, "DocsURL": home and f"{pages}/engines.html#unreal-engine", "SupportURL": home}
        for name, url in urls.items():  # in place: the file's order and tabs stay
            text = text.replace(f'"{name}": ""', f'"{name}": {json.dumps(url)}')
        file.write_text(text, encoding="utf-8")
        return
    if home and "unity" in description:
        description["author"]["url"] = home
        description.update(documentationUrl=f"{pages}/engines.html#unity", changelogUrl=f"{home}/docs/CHANGELOG.html",
                           licensesUrl=f"{home}/docs/LICENSE.html")
    elif home:
        description["homepage"] = f"{pages}/languages.html#web"
    if repository:
        description["repository"] = {"type": "git", "url": repository}
    if home or repository:
        file.write_text(json.dumps(description, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    try:
        write(Path(sys.argv[1]))
    except (IndexError, OSError, ValueError) as error:
        sys.exit(f"addresses.py: {error}\n{__doc__}" if isinstance(error, IndexError) else f"addresses.py: {error}")
