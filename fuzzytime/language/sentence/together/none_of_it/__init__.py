"""What is no instruction of its own.

Said of orders given before: ``orders_again``, ``after_all``, ``again_before``. None at all: ``doubts``,
``what_was``, ``how_things_are``, ``needed_lines``. Words that name no time: ``naming``, ``how_much``.
Words of none: ``unused``; those that are all the name of an entry, ``named_whole``.
"""
