"""Many task files planned at once: an answer each, in order, on this machine's processes or a cluster's."""
