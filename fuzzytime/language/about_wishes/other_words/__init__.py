"""A line in other words: ``rewording``, ``merging`` its time with the old one, ``replacing``, ``respelling``.

Which time is meant by ``answers``.
"""
