"""The study's commands by name."""

import typer

from fuzzytime_cli.study import collecting, keeping, using

app = typer.Typer(rich_markup_mode=None)
app.command("serve", short_help="Serve the page on which people draw.")(collecting.serve)
app.command("simulate", short_help="Invent participants with a known truth.")(collecting.simulate)
app.command("list")(keeping.list_)
app.command("exclude", short_help="Exclude a participant, or take that back.")(keeping.exclude)
app.command("import")(keeping.import_)
app.command("export")(keeping.export)
app.command("ratings", short_help="Show or export your own ratings of starts.")(keeping.ratings)
app.command("analyse", short_help="Analyse a study: a summary, or a report.")(using.analyse)
app.command("calibrate", short_help="Write the rule table that a study amounts to.")(using.calibrate)
