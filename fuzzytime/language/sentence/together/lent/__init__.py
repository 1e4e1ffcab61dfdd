"""Words that are lent (``lending``): a verb (``verbs_again``), who is asked (``requested_too``).

All that was asked for, done again, is ``again_before``.
"""
