"""Words that are lent (``lending``): a verb (``verbs_again``), and who is asked (``requested_too``)."""
