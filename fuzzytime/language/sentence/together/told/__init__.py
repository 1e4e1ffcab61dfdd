"""What is told beside instructions: ``told_beside``, ``ends_told``, ``lengths``, ``opening_hours``.

What has to be done because of it: ``reasons_told``.
"""
