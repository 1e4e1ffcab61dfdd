"""fuzzytime: from what people say about time to the schedule that satisfies them most."""
