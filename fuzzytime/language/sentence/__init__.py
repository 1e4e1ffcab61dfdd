"""What stands around the times of a text: instructions, operations, clauses, references, by the dependency tree."""
