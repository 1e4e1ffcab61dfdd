"""`fuzzytime study`: collect what people draw, analyse it, and make a rule table of it."""

import typer

from fuzzytime_cli.study import collecting, keeping, using

app = typer.Typer(
    help="Collect what people draw, analyse it, and make a rule table of it.", no_args_is_help=True
)
app.command("serve")(collecting.serve)
app.command("simulate")(collecting.simulate)
app.command("list")(keeping.list_)
app.command("exclude")(keeping.exclude)
app.command("import")(keeping.import_)
app.command("export")(keeping.export)
app.command("analyse")(using.analyse)
app.command("calibrate")(using.calibrate)
