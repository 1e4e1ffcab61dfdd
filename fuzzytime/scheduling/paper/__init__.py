"""The paper's own methods, for comparison: exhaustive sampling, hill climbing, annealing, genetic search."""
