"""An analysis as numbers, figures and a page.

``numbers`` as JSON, ``plots``, and a ``report`` on a ``report_page``.
"""
