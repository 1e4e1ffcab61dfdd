"""What a further wish shares with the first (``further_wishes``): where it begins (``borrowing``).

What is said of both: ``frames``; which of the words hold for another thing: ``other_things``,
and where that is put next: ``other_places``.
"""
