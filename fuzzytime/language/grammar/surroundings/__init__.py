"""What stands around a stretch of words (``surroundings``), and whether it makes it something else.

What stands ``behind_times``; whether a number is an amount (``measuring``), or what a clause has ``compared``
a thing to; words ``looked_up`` once.
"""
