"""What the command reads.

A ``source`` holds ``lines`` of instructions or a ``task_file`` with its ``surroundings`` and ``functions``; a
``calendar`` tells when one is busy.
"""
