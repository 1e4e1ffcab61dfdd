"""What a plan can be written as."""
