"""From a time requirement and a context to a satisfaction function."""
