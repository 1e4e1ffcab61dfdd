"""Write what the program says today into the documents: ``python docs/refresh.py``.

That is what commands write in console blocks, and what words mean in tables (``tests/meanings.py``). Blocks
with a line ``…`` are left as they are. Look at the difference before you commit it.
"""

import sys
import tempfile
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent.parent / name) for name in ("tests", "cli", ".")]

from console import ROOT, examples_of, fits, written_for
from meanings import with_meanings


def refreshed(path: Path) -> str:
    """Give a document with every console block, and every table, as the program writes it today."""
    text = with_meanings(path)
    for example in list(examples_of(path)):
        with tempfile.TemporaryDirectory() as folder:
            written = written_for(example, Path(folder))
        said = f"$ {example.command}\n{example.expected}"
        if fits(example.expected, written):
            continue
        if "\n…\n" in f"\n{example.expected}":
            print(f"left as it is: {example}")
            continue
        now = "".join(f"{line.rstrip()}\n" for line in written.rstrip("\n").split("\n"))
        tail = "\n" if example.expected.endswith("\n\n") else ""
        text = text.replace(said, f"$ {example.command}\n{now}{tail}", 1)
        print(f"refreshed: {example}")
    return text


def main() -> None:
    """Refresh the documents named, or all."""
    named = [Path(name).resolve() for name in sys.argv[1:]]
    everything = [ROOT / "README.md", *ROOT.glob("docs/**/*.md"), *ROOT.glob("tests/transcripts/*.md")]
    for path in named or sorted(everything):
        path.write_text(refreshed(path), encoding="utf-8")


main()
