"""Finding times in a text: words and their tables, rules and the chart that applies them.

Nothing here knows a construction: rules are in ``fuzzytime.language.english``. What is found is judged by
what stands around it, so that numbers and names are no times.

From a text to readings
    Words: ``words``, what is quoted (``quotes``), ``word_tables``, ``lexicon``, ``word_groups``,
    ``verb_groups``, ``timetables``, ``spelling``, ``transliteration``, ``numerals``.
    Rules applied, and the best readings chosen: ``chart``, ``spans``.
    What times lend each other: ``lending``, ``lent``; what is ``due`` behind "for", and how long
    (``typed_hours``); what is ``denied``.
    What looks like a time and is none: ``leftovers``, ``countdowns``, but ``called_things``.

Whether a reading is a time where it stands
    ``judging``, by its ``surroundings``, what stands ``behind_times``, what is ``looked_up`` there, and by
    ``measuring``.
"""
