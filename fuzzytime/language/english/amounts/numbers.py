"""How much of a unit: numbers, fractions, and both together."""

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer, Typed
from fuzzytime.language.meaning.units import Quantity

grammar = Grammar()


@grammar.rule("quantity", "<integer>")
@grammar.rule("quantity", "a|an full|further|extra|additional|mere|whole <integer>", weight=0.1)
def whole(number: Integer) -> Quantity:
    """Eight, 8; a full ten (minutes), a further five."""
    return Quantity(number.value)


@grammar.rule("quantity", "<decimal>")
def decimal(number: Typed) -> Quantity:
    """2.5."""
    return Quantity(float(number.parts[0]))


@grammar.rule("quantity", "<n,n>", weight=0.2)
def decimal_comma(number: Typed) -> Quantity:
    """2,5, as most of Europe types it."""
    return Quantity(float(".".join(number.parts)))


@grammar.rule("quantity", "<n,nnn>", weight=0.2)
def thousands(number: Typed) -> Quantity:
    """1,000."""
    return Quantity(float("".join(number.parts)))


@grammar.rule("decimals", "point <integer>", "point <integer> <integer>")
def spoken_decimals(first: Integer, second: Integer | None = None) -> str | None:
    """Point five, point twenty-five, point two five."""
    if first.digits or (second is not None and (second.digits or max(first.value, second.value) > 9)):
        return None
    return f".{first.value}{'' if second is None else second.value}"


@grammar.rule("quantity", "<integer>? <decimals>", weight=0.1)
def spoken_decimal(number: Integer | None, decimals: str) -> Quantity:
    """One point five, point seven five."""
    return Quantity(float(f"{0 if number is None else number.value}{decimals}"))


DOZEN = 12


@grammar.rule("quantity", "a? dozen", weight=0.1)
def dozen() -> Quantity:
    """A dozen (minutes)."""
    return Quantity(DOZEN)


@grammar.rule("quantity", "half a? dozen", weight=0.2)
def half_a_dozen() -> Quantity:
    """Half a dozen (times)."""
    return Quantity(DOZEN / 2)


@grammar.rule("quantity", "<integer> dozen", weight=0.1)
def dozens(number: Integer) -> Quantity:
    """Two dozen (hours)."""
    return Quantity(DOZEN * number.value)


@grammar.rule("quantity", "a|an")
def one() -> Quantity:
    """A minute, an hour."""
    return Quantity(1, indefinite=True)


@grammar.rule("fraction", "<ratio>")
def ratio(number: Typed) -> float | None:
    """1/2, 3/4; but 2/15 is a date."""
    return number[0] / number[1] if number[1] in {2, 3, 4} and number[0] < number[1] else None


@grammar.rule("fraction", "a <fraction>", "one <fraction>", "an <fraction>")
def one_fraction(fraction: float) -> float:
    """A half, one quarter."""
    return fraction


@grammar.rule("fraction", "<integer> quarters|quarter", weight=0.1)
def quarters(number: Integer) -> float | None:
    """Three quarters."""
    return number.value / 4 if number.value < 4 else None


@grammar.rule("fraction", "<integer> thirds", weight=0.1)
def thirds(number: Integer) -> float | None:
    """Two thirds."""
    return number.value / 3 if number.value < 3 else None


@grammar.rule("quantity", "<integer> and? <fraction>")
def mixed(number: Integer, fraction: float) -> Quantity:
    """Two and a half, one and three quarters, 1 1/2."""
    return Quantity(number.value + fraction)


@grammar.rule(
    "quantity", "<quantity> more|additional|extra|other|fewer|further|full|whole|short|long|good|last|final"
)
def added(quantity: Quantity) -> Quantity:
    """Two more minutes, three additional hours, two full days."""
    return quantity


@grammar.rule("quantity", "<integer> and a bit|little", "<integer> -? odd", weight=0.1)
def and_a_bit(number: Integer) -> Quantity:
    """Three and a bit (hours), twenty-odd (minutes)."""
    return Quantity(number.value, ("about",))


@grammar.rule("quantity", "a|an good|solid <integer>", weight=0.1)
def a_good(number: Integer) -> Quantity:
    """A good ten (minutes): that many, or more."""
    return Quantity(number.value, ("at least",))


@grammar.rule("quantity", "another <integer>?")
def another(number: Integer | None) -> Quantity:
    """Another hour, another five minutes."""
    return Quantity(1, indefinite=True) if number is None else Quantity(number.value)


@grammar.rule("quantity", "<hedge> <quantity>", weight=-0.1)
def hedged(hedge: str, quantity: Quantity) -> Quantity:
    """About ten (minutes), at least two."""
    return Quantity(quantity.value, (hedge, *quantity.hedges), quantity.indefinite)


@grammar.rule("quantity", "<quantity> <hedge_after>", "<quantity> - <hedge_after>", weight=-0.1)
def hedged_after(quantity: Quantity, hedge: str) -> Quantity:
    """Ten or so (minutes), 10-ish, twenty-ish."""
    return Quantity(quantity.value, (*quantity.hedges, hedge), quantity.indefinite)
