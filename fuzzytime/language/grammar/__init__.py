"""Finding times in a text: words and their tables, rules and the chart that applies them.

Nothing here knows a construction: rules are in ``fuzzytime.language.english``. What is found is judged by
what stands around it, so that numbers and names are no times. From the ground:

``words``
    A text cut into words; what is quoted in it.
``chart``
    Applies the rules of a grammar; ``patterns`` are what these are written in.
``lexicon``
    What words mean, as ``word_tables`` say, and which are meant (``typed_words``); ``numerals`` are numbers,
    ``timetables`` lists of hours.
``surroundings``
    What stands before and behind a stretch of words.
``understood``
    What is not said with a time, and is understood with it.
``judging``
    Whether a reading is a time where it stands.
``spans``
    The best readings, chosen.
``leftovers``
    What looks like a time and is part of none.
"""
