"""What stands around the times of a text, by the dependency tree: operations, clauses, references."""
