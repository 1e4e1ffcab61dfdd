"""Orders that are about wishes (``changes``): ``moves`` to another time, ``exceptions`` from a repetition."""
