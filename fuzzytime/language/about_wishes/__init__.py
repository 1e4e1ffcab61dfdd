"""What is said about what was asked for already: "no, make it six", "cancel the call", "when do I stir?".

A line is ``said``, and what it is ``about`` is a value; ``reading`` tells which kind of line it is:

What is to be otherwise
    ``changes`` of which wishes (``meant``) and by how much (``lengths``); ``turns`` to what was just said;
    ``corrections``; ``things`` alone, or ``called_by_time``; a line in ``other_words``.
What is told or asked
    What somebody has ``told``; what is ``asked``.
"""
