"""What stands around the times of a text, by the dependency tree: operations, clauses, references.

Two passes read a text. The first cuts it into parts and gives each a tree, and each part is sketched; the
second, ``compose``, grounds the sketches, takes what each asks for (``asked_for``) and when that is
``required``, and resolves what they say of each other. A construction is a module, named after what it
reads, in the room of its kind. From the ground:

``trees``
    The dependency tree, where it comes from, and the words that it holds; ``tokens`` gives them labels.
``verbs``
    What verbs say: what is to be done, and what happens by itself.
``clauses``
    What clauses about time say.
``references``
    Which instruction words refer to, and times that count from it.
``segments``
    Where instructions begin and end: the first pass.
``sketches``
    One instruction before it is grounded: its times, its clauses, what is to be done.
``together``
    What the instructions of a text lend each other.
"""
