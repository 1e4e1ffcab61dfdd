"""SVG and HTML elements, written safely: every text and attribute escaped, no control characters."""

from xml.sax.saxutils import escape, quoteattr

from fuzzytime_cli.render import plain

Attribute = str | float


def words(text: str) -> str:
    """Make typed text safe as the content of an element."""
    return escape(plain(text))


def number(value: float) -> str:
    """Write a coordinate with no more digits than a screen shows.

    >>> number(3.0), number(2.456)
    ('3', '2.46')
    """
    return f"{value:.2f}".rstrip("0").rstrip(".")


def element(name: str, content: str | None = None, **attributes: Attribute) -> str:
    """Write an element whose content is safe already; ``class_`` and ``text_anchor`` lose their underscores.

    >>> element("line", x1=0, class_="grid", text_anchor="end")
    '<line x1="0" class="grid" text-anchor="end"/>'
    """
    written = "".join(
        f" {key.strip('_').replace('_', '-')}={quoteattr(value if isinstance(value, str) else number(value))}"
        for key, value in attributes.items()
    )
    return f"<{name}{written}/>" if content is None else f"<{name}{written}>{content}</{name}>"


def picture(width: float, height: float, title: str, style: str, content: str) -> str:
    """Write a whole SVG document."""
    return (
        element(
            "svg",
            element("title", words(title)) + element("style", style) + content,
            xmlns="http://www.w3.org/2000/svg",
            viewBox=f"0 0 {number(width)} {number(height)}",
            width=width,
            height=height,
            role="img",
        )
        + "\n"
    )
