"""Good schedules, soon: local search over orders, and improvement part by part; nothing is proved here."""
