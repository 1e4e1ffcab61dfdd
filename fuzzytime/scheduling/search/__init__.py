"""Good schedules, soon: local search over orders, and improvement part by part; nothing is proved here.

A search begins where work is ``expected`` or from a ``warm`` start. A ``local_search`` improves a ``rough``
plan, with ``kicks``, or an order where waiting never helps (``dynasearch``); long schedules improve in
``stretches``, each one of their ``parts``.
"""
