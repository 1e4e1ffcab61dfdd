"""The study's page over HTTP.

A ``server``, the ``handler`` of its requests, and the ``service`` that they ask.
"""
