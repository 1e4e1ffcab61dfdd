"""The study's page over HTTP."""
