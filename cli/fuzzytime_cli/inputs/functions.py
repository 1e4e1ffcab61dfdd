"""Satisfaction functions written in YAML: ``{trapezoid: [0 s, 60 s, 120 s, 300 s]}`` and its sisters."""

from collections.abc import Callable, Mapping
from functools import partial

from fuzzytime.documents.nodes import Mapping as MappingNode
from fuzzytime.documents.nodes import Node, Reader
from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import NEVER, Bell, Rectangle, Sampled, SatisfactionFunction, Trapezoid, Triangle

CORNERED: Mapping[str, tuple[type[Trapezoid | Triangle | Rectangle], int]] = {
    "trapezoid": (Trapezoid, 4),
    "triangle": (Triangle, 3),
    "rectangle": (Rectangle, 2),
}
BELL = ("centre", "width", "slope")


def read_function(reader: Reader, node: Node, key: str) -> SatisfactionFunction:
    """Read one function; a mistake is noted in the reader and gives `NEVER`."""
    shapes = reader.mapping(node, key, (*CORNERED, "bell", "points"))
    if len(shapes) != 1:
        if isinstance(node, MappingNode) and len(node.entries) != 1:
            reader.mistake(node, key, "give one of trapezoid, triangle, rectangle, bell, points")
        return NEVER
    ((shape, value),) = shapes.items()
    path = f"{key}.{shape}"
    before = len(reader.mistakes)
    build: Callable[[], SatisfactionFunction]
    if shape == "bell":
        build = _bell(reader, value, path)
    elif shape == "points":
        build = _points(reader, value, path)
    else:
        kind, count = CORNERED[shape]
        corners = reader.sequence(value, path, count)
        build = partial(kind, *(reader.duration(corner, f"{path}[{i}]") for i, corner in enumerate(corners)))
    if len(reader.mistakes) > before:
        return NEVER
    try:
        return build()
    except FuzzytimeError as error:
        reader.mistake(value, path, str(error))
        return NEVER


def _bell(reader: Reader, node: Node, key: str) -> Callable[[], SatisfactionFunction]:
    fields = reader.mapping(node, key, BELL, BELL)
    if len(fields) < len(BELL):
        return partial(Bell, 0.0, 1.0, 1.0)
    centre, width = (reader.duration(fields[name], f"{key}.{name}") for name in BELL[:2])
    return partial(Bell, centre, width, reader.number(fields["slope"], f"{key}.slope"))


def _points(reader: Reader, node: Node, key: str) -> Callable[[], SatisfactionFunction]:
    times, values = [], []
    for index, point in enumerate(reader.sequence(node, key)):
        pair = reader.sequence(point, f"{key}[{index}]", 2)
        if pair:
            times.append(reader.duration(pair[0], f"{key}[{index}][0]"))
            values.append(reader.number(pair[1], f"{key}[{index}][1]", 0.0, 1.0))
    return partial(Sampled, times, values)
