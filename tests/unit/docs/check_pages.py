#!/usr/bin/env python3
"""Keeps the pages true:  check_pages.py ROOT JAMSCAPE

Every relative link leads to a file, every study in a page is one the program accepts, and every command and long option
a page shows is one the program has. Prints `file:line: what is wrong`.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

root, program = Path(sys.argv[1]).resolve(), sys.argv[2]
findings = []


def ask(*words, **more):
    return subprocess.run([program, *words], capture_output=True, text=True, stdin=subprocess.DEVNULL, **more)


def helps():
    """{command: its --help}"""
    text = ask("--help").stdout
    names = re.findall(r"^  (\w+)  ", text[text.index("Subcommands:"):], re.MULTILINE)
    return {name: ask(name, "--help").stdout for name in names}


def check_links(place, line):
    for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", line):
        if "://" not in target and not (place.parent / target).exists():
            yield f"the link to {target} leads nowhere"


def check_commands(line, known):
    # In running text commands stand in backquotes, in blocks they start the line.
    for command in re.findall(r"(?:^    |`)(?:\./build/)?jamscape (\w[^`]*)", line):
        name, *words = command.split()
        if name not in known:
            yield f"there is no command '{name}'"
            continue
        for option in (w.split("=")[0] for w in words if w.startswith("--")):
            if option not in known[name]:
                yield f"'{name}' has no option {option}"


def check_study(text):
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "study.toml").write_text(text)
        run = ask("run", "study.toml", "--dry-run", cwd=folder)
        if run.returncode != 0:
            yield f"the program refuses this study: {run.stderr.strip()}"


known = helps()
pages = [p for p in root.glob("*.md")] + sorted((root / "docs").rglob("*.md"))
studies = 0
for page in pages:
    text = page.read_text()
    for number, line in enumerate(text.splitlines(), 1):
        for problem in (*check_links(page, line), *check_commands(line, known)):
            findings.append(f"{page.relative_to(root)}:{number}: {problem}")
    for block in re.finditer(r"^```toml\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        studies += 1
        for problem in check_study(block.group(1)):
            findings.append(f"{page.relative_to(root)}:{text.count(chr(10), 0, block.start()) + 2}: {problem}")

if len(known) < 5 or len(pages) < 5 or studies == 0:
    findings.append(f"looked at {len(pages)} pages, {studies} studies and {len(known)} commands: that cannot be all")
print("\n".join(findings) or f"{len(pages)} pages, {studies} studies and {len(known)} commands agree")
sys.exit(1 if findings else 0)
