"""From what people draw to the table that plans (the paper's section III-C)."""
