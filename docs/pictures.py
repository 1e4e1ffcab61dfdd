"""Make the README's pictures by the program itself: ``python docs/pictures.py``.

``images/breakfast.svg`` is what ``plan --format svg`` writes; ``images/conversation.svg`` records a
conversation, line by line as a person types it, with a clock that this script moves.
"""

import io
import os
import sys
import tempfile
from datetime import datetime, timedelta
from pathlib import Path
from zoneinfo import ZoneInfo

sys.path[:0] = [str(Path(__file__).parent.parent / name) for name in ("tests", "cli", ".")]

from rich.console import Console
from rich.text import Text

from console import ROOT, written_by
from fuzzytime.interpreter import Interpreter
from fuzzytime.scheduling import THRESHOLD, Auto, Limits
from fuzzytime_cli.repl.conversation import Conversation
from fuzzytime_cli.repl.turn import Turns
from fuzzytime_cli.session import SessionStore

IMAGES = ROOT / "docs" / "images"
BEGIN = datetime(2026, 3, 4, 17, 0, tzinfo=ZoneInfo("Europe/Berlin"))
SPOKEN = (
    (0, "Put the potatoes on in five minutes"),
    (20, "Fry the fish in about eight minutes"),
    (30, ":ctx pan_temp=120"),
    (60, "Set the table before dinner, then light the candles"),
    (90, "Call mum at half past six"),
    (120, "push everything back by ten minutes"),
    (150, "why is the fish so late?"),
)
WIDTH = 80

# A terminal window without the outside fonts that Rich's own form would fetch.
FORM = """<svg class="rich-terminal" viewBox="0 0 {width} {height}" xmlns="http://www.w3.org/2000/svg">
<style>
.{unique_id}-matrix {{ font-family: ui-monospace, Menlo, Consolas, "DejaVu Sans Mono", monospace;
  font-size: {char_height}px; line-height: {line_height}px; font-variant-east-asian: full-width; }}
.{unique_id}-title {{ font-size: 18px; font-weight: bold; font-family: sans-serif; }}
{styles}
</style>
<defs>
<clipPath id="{unique_id}-clip-terminal">
<rect x="0" y="0" width="{terminal_width}" height="{terminal_height}" />
</clipPath>
{lines}
</defs>
{chrome}
<g transform="translate({terminal_x}, {terminal_y})" clip-path="url(#{unique_id}-clip-terminal)">
{backgrounds}
<g class="{unique_id}-matrix">
{matrix}
</g>
</g>
</svg>
"""


def conversation() -> str:
    """Hold the conversation and give its recording."""
    held = Conversation(
        SessionStore(None), "dinner", Interpreter.shipped(), lambda _: Auto(), Limits(), THRESHOLD
    )
    turns = Turns(held, WIDTH, asks=True)
    screen = Console(
        file=io.StringIO(), record=True, width=WIDTH, force_terminal=True, color_system="standard",
        markup=False, highlight=False, emoji=False, soft_wrap=True,
    )  # fmt: skip
    turns.opened(BEGIN)
    for seconds, line in SPOKEN:
        now = BEGIN + timedelta(seconds=seconds)
        for news in turns.tick(now):
            screen.print(news)
        screen.print(Text.assemble(("› ", "bold green"), line))
        reply = turns.take(line, now)
        for shown in reply.lines:
            screen.print(shown)
    return screen.export_svg(title="fuzzytime", code_format=FORM, unique_id="fuzzytime")


def main() -> None:
    """Write both pictures."""
    os.environ["TZ"] = "UTC"
    with tempfile.TemporaryDirectory() as folder:
        plan = "fuzzytime plan examples/breakfast.txt --now 2026-03-04T07:00 --format svg"
        (IMAGES / "breakfast.svg").write_text(written_by(plan, Path(folder)), encoding="utf-8")
    (IMAGES / "conversation.svg").write_text(conversation(), encoding="utf-8")


main()
