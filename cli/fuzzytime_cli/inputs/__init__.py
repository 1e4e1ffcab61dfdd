"""What the command reads: instructions a line, YAML task files, calendars."""
