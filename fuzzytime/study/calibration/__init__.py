"""From answers and ratings to a rule table that plans by them."""
