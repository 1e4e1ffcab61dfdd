"""The study's commands by name."""

import typer

from fuzzytime_cli.study import collecting, keeping, using

app = typer.Typer(rich_markup_mode=None)
app.command("serve")(collecting.serve)
app.command("simulate")(collecting.simulate)
app.command("list")(keeping.list_)
app.command("exclude")(keeping.exclude)
app.command("import")(keeping.import_)
app.command("export")(keeping.export)
app.command("ratings")(keeping.ratings)
app.command("analyse")(using.analyse)
app.command("calibrate")(using.calibrate)
