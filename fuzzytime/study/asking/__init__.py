"""What a study asks: its design, read from YAML, and its page's words."""
