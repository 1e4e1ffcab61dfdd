"""From an order to start times: in slots, and in continuous time.

In slots: ``orders``. In continuous time: ``chains`` where ψ is log-concave, ``candidates`` else,
``coupled`` under lags of any kind; ``settle`` picks among them.
"""
