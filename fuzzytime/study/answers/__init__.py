"""What people drew and said, as values; synthetic people; rows for other programs."""
