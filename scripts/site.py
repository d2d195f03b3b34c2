#!/usr/bin/python3
"""Makes the documentation site: all pages that README.md leads to, and the API reference, with a search.    site.py [FOLDER]
FOLDER: default build/site. Look at it with: python3 -m http.server -d build/site
Needs mkdocs and mkdocs-material and doxygen: scripts/setup.sh test. SPDX-License-Identifier: MIT"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCE = ROOT / "build/site-source"
CONTENTS = "docs/README.md"  # lists the pages: the site's navigation
LINK = re.compile(r"(\]\()([^)#:\s]+)((?:#[^)\s]*)?\))")
FENCE = re.compile(r"^(?:```|    ).*?(?=\n(?!    )|\Z)|^```.*?^```$", re.S | re.M)
LANGUAGES = {".h": "c", ".c": "c", ".hpp": "cpp", ".cpp": "cpp", ".py": "python", ".sh": "bash", ".mjs": "javascript", ".js": "javascript", ".cs": "csharp"}

CONFIG = """site_name: Langevin Rigid {version}
site_description: Falling leaves, paper, petals and confetti for games, with the same bits on every machine
docs_dir: {source}
site_dir: {out}
use_directory_urls: false
theme:
  name: material
  font: false
  palette:
    - scheme: default
      primary: deep orange
      toggle: {{icon: material/weather-night, name: Dark}}
    - scheme: slate
      primary: deep orange
      toggle: {{icon: material/weather-sunny, name: Light}}
  features: [navigation.sections, navigation.top, content.code.annotate, search.highlight]
extra_css: [wide.css]
plugins: [search]
markdown_extensions:
  - tables
  - toc: {{permalink: true}}
  - pymdownx.highlight
  - pymdownx.superfences
nav:
{nav}"""


def targets(text):
    """Relative links outside of code."""
    return {m[2] for m in LINK.finditer(FENCE.sub("", text))}


def as_page(path):
    """Where a linked file is in the site: text becomes a page."""
    if path.is_dir():
        return path / "index.md"
    return path if path.suffix in (".md", ".png", ".svg", ".json") else path.with_name(path.name + ".md")


def page_of(path):
    """The page for a file or a folder of sources."""
    name = path.relative_to(ROOT)
    if path.is_dir():
        files = sorted(p for p in path.iterdir() if p.is_file())
        return f"# {name}\n\n" + "".join(f"- [{p.name}]({p.name})\n" for p in files)
    return f"# {name}\n\n```{LANGUAGES.get(path.suffix, 'text')}\n{path.read_text(encoding='utf-8')}\n```\n"


def gather():
    """Copies README.md and all that it leads to; links to sources lead to pages with them."""
    waiting, seen = [ROOT / "README.md"], set()
    while waiting:
        path = waiting.pop()
        if path in seen:
            continue
        seen.add(path)
        to = SOURCE / as_page(path).relative_to(ROOT)
        to.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix in (".png", ".svg", ".json"):
            shutil.copy(path, to)
            continue
        text = path.read_text(encoding="utf-8") if path.suffix == ".md" else page_of(path)
        if path.suffix == ".md" or path.is_dir():
            base = path if path.is_dir() else path.parent
            for target in targets(text):
                linked = (base / target).resolve()
                if not linked.is_relative_to(ROOT) or not linked.exists():
                    sys.exit(f"{path.relative_to(ROOT)}: no such file: {target}")
                waiting.append(linked)

            def relinked(m, base=base):
                linked = (base / m[2]).resolve()
                return m[1] + os.path.relpath(as_page(linked), base) + m[3] if linked.exists() else m[0]

            text = LINK.sub(relinked, text)
        to.write_text(text, encoding="utf-8")
    return seen


def navigation():
    """The sections and tables of the contents page."""
    lines = ["  - Home: README.md", "  - API reference: api/index.html"]
    for line in (ROOT / CONTENTS).read_text(encoding="utf-8").splitlines():
        if line.startswith("## "):
            lines.append(f"  - {line[3:]}:")
        elif m := re.match(r"\| \[[^]]+\]\(([^)]+)\)", line):
            page = os.path.normpath(os.path.join(os.path.dirname(CONTENTS), m[1]))
            title = re.match(r"# (.*)", (ROOT / page).read_text(encoding="utf-8"))[1]
            lines.append(f"      - {title!r}: {page}")
    return "\n".join(lines) + "\n  - Samples: samples/README.md\n  - Changes: CHANGELOG.md\n"


def main(out):
    shutil.rmtree(SOURCE, ignore_errors=True)
    pages = gather()
    subprocess.run([ROOT / "scripts/api_reference.sh"], check=True, stdout=subprocess.DEVNULL)
    shutil.copytree(ROOT / "build/api/html", SOURCE / "api")
    header = (ROOT / "include/langevin_rigid.h").read_text(encoding="utf-8")
    version = ".".join(re.search(rf"define LR_VERSION_{part} (\d+)", header)[1] for part in ("MAJOR", "MINOR", "PATCH"))
    # Room for lines of code; drawings that are shifted on a phone rather than made illegible.
    (SOURCE / "wide.css").write_text(".md-grid{max-width:76rem}.md-typeset pre>code{font-size:.76em}\n@media(max-width:44em){p:has(>img[src*='concepts/'])"
                                     "{overflow-x:auto}.md-typeset img[src*='concepts/']{max-width:none;width:34rem}}\n", encoding="utf-8")
    config = ROOT / "build/site.yml"
    config.write_text(CONFIG.format(version=version, source=SOURCE, out=out, nav=navigation()), encoding="utf-8")
    subprocess.run(["/usr/bin/mkdocs", "--quiet", "build", "--strict", "--clean", "--config-file", config], check=True)
    print(f"{len(pages)} pages and pictures: {out}")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/site").resolve())
