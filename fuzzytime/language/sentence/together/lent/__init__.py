"""Words that are lent (``lending``): a verb (``verbs_again``), all of it (``again_before``), who is asked (``requested_too``)."""
