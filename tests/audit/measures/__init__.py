"""One file a family of measures; importing them registers their audits."""
from importlib import import_module
from pathlib import Path

for file in sorted(Path(__file__).parent.glob("[a-z]*.py")):
    import_module(f"measures.{file.stem}")
