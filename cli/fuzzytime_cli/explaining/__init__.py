"""An instruction explained: tree, requirement, rows and rules, ψ, and why it is planned when it is.

``explanation`` is the whole: the ``words``, the ``origins`` of a satisfaction function, and its ``charts``.
"""

from fuzzytime_cli.explaining.charts import chart_of
from fuzzytime_cli.explaining.explanation import explanation_lines, reading_lines, rules_lines

__all__ = ["chart_of", "explanation_lines", "reading_lines", "rules_lines"]
