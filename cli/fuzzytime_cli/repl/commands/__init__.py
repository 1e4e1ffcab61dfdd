"""Commands that start with a colon.

``by_name`` they are ``changing``, ``moving``, ``looking``, ``rating``, ``saving``.
"""
