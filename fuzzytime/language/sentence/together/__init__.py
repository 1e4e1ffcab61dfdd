"""What the instructions of a text lend each other, in their ``sketches``; what times count from: ``moments``.

``lent``
    Words that one instruction takes over from another.
``times``
    Times that several instructions share, and several times of one.
``days``
    Days and lines that hold for instructions elsewhere.
``told``
    What is told beside them: lengths, hours, reasons.
``none_of_it``
    What is no instruction of its own, or only of another.
"""
