"""Calendars in which feasts have their days, each a module; none costs anything before it is asked for.

What a feast asks of its calendar: ``observance``.
By arithmetic: ``easter``, ``hebrew``.
By the sun and the moon: ``islamic``, ``east_asian``, ``persian``, ``hindu``.
Where these stand: ``astronomy``, with the numbers of ``series``.
"""
