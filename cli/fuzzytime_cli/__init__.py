"""The command `fuzzytime`."""
