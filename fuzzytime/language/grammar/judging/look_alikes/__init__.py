"""What looks like a time: ``figures``, ``proper_names``, words ``spoken_of``, and ``things_of_times``."""
