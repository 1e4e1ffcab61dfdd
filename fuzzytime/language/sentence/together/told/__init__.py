"""What is told beside instructions: ``told_beside``, ``lengths``, what is ``waited``, ``opening_hours``.

What has to be done because of it: ``reasons_told``, ``consequences``.
"""
