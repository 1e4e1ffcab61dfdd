"""What stands beside a reading and makes it no time, or another one.

It is ``cuts`` out of a larger word, belongs to ``particles`` of a verb or to ``titles``, names ``events``, or
counts ``doses`` of what is taken, or says that a time is one of ``new_times``; but ``dining`` says when.
"""
