"""The dependency tree, where it comes from, and the words that it holds.

A tree is a value (``tree``), with ``tags`` and the paper's ``labels``, from a ``model``, which has
``model_files`` and hears a text by its ``sounding``, or from a ``parse_cache``. How its words are said again
is ``wording``, which of them name something ``content_words``, what they name ``named``, and which only say
why ``reasons``.
"""
