"""What verbs say: what is to be done, and what happens by itself.

From the ground:

``meant``
    The verb that is meant, and which moment of what is done.
``places``
    Where and how it is done.
``statements``
    What is only told, and who is said to do it.
``operations``
    What is to be done: the verb, its object and the rest.
``without_verbs``
    What is to be done, or happens, where nobody says a verb.
"""
