"""A live run: a plan carried out in time, told as events, and made anew when what arrives matters.

``dispatcher`` decides what happens, with what lies ahead (``outlook``, ``planning``) and what goes on
(``progress``, ``ledger``), and knows no clock; ``clock`` and ``inbox`` bring it time and news
(``feeds``, ``messages``), and ``loop`` joins them at its ``pace``, once ``start`` has put the run
together; ``programs`` runs commands, ``hearsay`` is what people say meanwhile; ``events`` are what is
told, and ``display`` shows them.
"""
