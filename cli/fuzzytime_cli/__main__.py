"""``python -m fuzzytime_cli`` is the command `fuzzytime`."""

from fuzzytime_cli.entry import main

main()
