"""Where words meet the tables: rows, things, terms, numbers and clauses that a text names."""
