"""From typed words to instructions with time requirements; the only home of spaCy."""
