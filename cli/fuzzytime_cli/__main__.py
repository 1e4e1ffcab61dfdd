"""``python -m fuzzytime_cli`` is the command `fuzzytime`."""

from fuzzytime_cli.app import main

main()
