#!/usr/bin/env python3
"""Compares the include lines of the sources with the floors that CMake states.

    check_layers.py [ROOT]

prints one line `file:line: what is wrong` per finding and ends with 1 if there was one. What is checked:
  - the order of add_subdirectory(src/jamscape/...) in CMakeLists.txt names every module, and a module USES only what
    stands above it there;
  - a module includes only from itself and from the modules it USES, always from the root, and only files that exist;
  - every header has #pragma once, and every module a README.md.
"""
import re
import sys
from pathlib import Path

SOURCES = (".hpp", ".cpp", ".h", ".inl")


def line_of(text, offset):
    return text.count("\n", 0, offset) + 1


def floors(root):
    """Modules in the order of the top CMakeLists.txt, each with its line there."""
    text = (root / "CMakeLists.txt").read_text()
    found = re.finditer(r"^\s*add_subdirectory\(src/jamscape/(\w+)\)", text, re.MULTILINE)
    return {m.group(1): line_of(text, m.start(1)) for m in found}


def used_modules(cmake):
    """The USES of the jam_module() in a CMakeLists.txt, each with its line, or None where there is no jam_module()."""
    text = re.sub(r"#[^\n]*", lambda m: " " * len(m.group()), cmake.read_text())
    call = re.search(r"\bjam_module\(([^)]*)\)", text)
    if call is None:
        return None
    uses, keyword = {}, ""
    for word in re.finditer(r"\S+", call.group(1)):
        if word.group().isupper():
            keyword = word.group()
        elif keyword == "USES":
            uses[word.group()] = line_of(text, call.start(1) + word.start())
    return uses


def check_includes(root, path, allowed, findings):
    """`allowed`: the modules `path` may include from; None for programs, which may use all, and files beside them."""
    place = path.relative_to(root)
    pragma = False
    for number, line in enumerate(path.read_text().splitlines(), 1):
        pragma = pragma or line.strip() == "#pragma once"
        include = re.match(r'\s*#\s*include\s*("([^"]+)"|<(jamscape/[^>]+)>)', line)
        if not include:
            continue
        name = include.group(2) or include.group(3)
        module = name.split("/")
        if module[0] != "jamscape" or len(module) < 3:
            if allowed is not None and (path.parent / name).is_file():
                findings.append(f'{place}:{number}: "{name}" is not named from the root ("jamscape/<module>/...")')
        elif not (root / "src" / name).is_file():
            findings.append(f'{place}:{number}: there is no src/{name}')
        elif allowed is not None and module[1] not in allowed:
            findings.append(f'{place}:{number}: includes "{name}", but {path.parent.name} USES no {module[1]}')
    if path.suffix in (".hpp", ".h") and not pragma:
        findings.append(f"{place}:1: no #pragma once")


def check(root):
    findings = []
    order = floors(root)
    names = list(order)
    modules = sorted(p for p in (root / "src" / "jamscape").iterdir() if p.is_dir())
    for module in modules:
        name, cmake = module.name, module / "CMakeLists.txt"
        place = module.relative_to(root)
        if name not in order:
            findings.append(f"CMakeLists.txt:1: module {name} has no add_subdirectory({place})")
            continue
        if not (module / "README.md").is_file():
            findings.append(f"{place}/README.md:1: missing")
        uses = used_modules(cmake) if cmake.is_file() else None
        if uses is None:
            findings.append(f"{place}/CMakeLists.txt:1: no jam_module()")
            continue
        for other, line in uses.items():
            if other not in order:
                findings.append(f"{place}/CMakeLists.txt:{line}: {name} USES {other}, which is no module")
            elif names.index(other) >= names.index(name):
                findings.append(f"{place}/CMakeLists.txt:{line}: {name} USES {other}, which is not below it "
                                f"(CMakeLists.txt:{order[other]})")
        for path in sorted(p for p in module.rglob("*") if p.suffix in SOURCES):
            check_includes(root, path, {name, *uses}, findings)
    for folder in ("app", "bench", "tests"):
        for path in sorted(p for p in (root / folder).rglob("*") if p.suffix in SOURCES):
            check_includes(root, path, None, findings)
    return findings


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[3]).resolve()
    findings = check(root)
    print("\n".join(findings) if findings else "the floors hold")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
