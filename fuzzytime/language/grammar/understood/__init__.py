"""What is not said with a time, and is understood with it.

What times lend each other (``lending``), and when a number without a unit is ``lent`` one, or has that of
the steps around it (``minutes_of_steps``); what is ``due``
behind "for", and how long (``typed_hours``); what is ``waited`` before "and", and what is ``denied``.
Several times of one thing are ``lists``, whose members are ``filled`` by each other, and whose days and times
are ``crossed``.
"""
