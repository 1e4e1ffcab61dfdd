"""Finding times in a text: words and their tables, rules and the chart that applies them."""
