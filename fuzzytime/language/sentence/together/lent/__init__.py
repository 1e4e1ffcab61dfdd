"""Words that are lent (``lending``): a verb (``verbs_again``), who is asked (``requested_too``)."""
