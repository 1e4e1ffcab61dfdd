"""What time words mean: expressions that know no language, and how they become instants and requirements."""
