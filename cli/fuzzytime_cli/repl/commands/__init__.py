"""Commands that start with a colon.

``by_name`` they are ``changing``, said ``anew``, ``moving``, ``looking``, ``rating``, ``saving``.
"""
