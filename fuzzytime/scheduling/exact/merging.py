"""Labels that arrive in one block from several become one matrix: of each set the cheapest at every slot."""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.exact.memory import Masks, Memory
from fuzzytime.scheduling.problem.grid import Ints


class Piece(NamedTuple):
    """Labels that arrive in a block, from a row on: sets, and their costs, slot × set.

    ``origin`` is the block that they come from.
    """

    masks: Masks
    cost: Floats
    row: int
    origin: int


def merged(pieces: Sequence[Piece], memory: Memory, block: int, height: int) -> tuple[Masks, Floats]:
    """Make one matrix of all pieces that arrive in a block, and let time pass.

    Parameters
    ----------
    pieces
        At least one.
    memory
        Tells which bits close on the way.
    block
        Where they arrive.
    height
        Its slots.

    Returns
    -------
    Each set once, ascending, and their costs, an array of shape (height, sets); inf where none arrived yet.
    """
    closed = [memory.closed(piece.origin, block, piece.masks) for piece in pieces]
    every = np.concatenate([mine for mine, _ in closed])
    # Most pieces ascend: the stable sort, which comes with the index, merges them.
    masks, _, column = np.unique(every, return_index=True, return_inverse=True)
    cost, position = np.full((height, masks.size), np.inf), 0
    for (mine, extra), piece in zip(closed, pieces, strict=True):
        part = cost[piece.row : piece.row + piece.cost.shape[0]]
        columns = column[position : position + mine.size]
        if mine is piece.masks:
            # Where nothing closed on the way, no two sets became equal.
            lower(part, columns, piece.cost)
        else:
            lower(part, *_distinct(columns, piece.cost + extra))
        position += mine.size
    for before, row in pairwise(cost):
        np.minimum(before, row, out=row)
    return masks, cost


def lower(known: Floats, columns: Ints, cost: Floats) -> None:
    """Lower some columns, each named once, to what is cheaper there."""
    cheaper = known.take(columns, axis=1)
    np.minimum(cheaper, cost, out=cheaper)
    known[:, columns] = cheaper


def _distinct(columns: Ints, cost: Floats) -> tuple[Ints, Floats]:
    """Take the cheapest of columns that are named again, since closing made their sets equal."""
    order = columns.argsort(kind="stable")
    ascending = columns[order]
    heads = np.flatnonzero(np.concatenate([[True], ascending[1:] != ascending[:-1]]))
    if heads.size == columns.size:
        return columns, cost
    return ascending[heads], np.minimum.reduceat(cost.take(order, axis=1), heads, axis=1)
