"""From a requirement to ψ: lookup, rules, clauses, and adding what is fuzzy to what is fuzzy."""
