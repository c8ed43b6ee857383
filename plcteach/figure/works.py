"""The words for words: what is worked out of what, with the numbers where there are any, the flags, and rows of bits that move."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plcteach.core.area import Address
from plcteach.core.program import Assign, Value
from plcteach.core.text import NOTHING, Text, joined, same
from plcteach.figure.told import with_value
from plcteach.figure.when import fired, when
from plcteach.machine.shifts import shift_of
from plcteach.machine.sums import RULES, real
from plcteach.machine.words import wrapped

if TYPE_CHECKING:
    from plcteach.core.area import Kind
    from plcteach.core.program import Arg
    from plcteach.core.verb import Verb
    from plcteach.figure.told import Told

_SIGNS = {
    "add": "+", "sub": "-", "mul": "×", "div": "÷", "mul16": "×", "sum": "+", "difference": "-", "product": "×",
    "divmod": "÷", "parts": "÷", "radd": "+", "rsub": "-", "rmul": "×", "rdiv": "÷", "and": "AND", "or": "OR", "xor": "XOR",
}  # fmt: skip
_SAID = {
    "inc": Text("{a} + 1", "{a} + 1"),
    "dec": Text("{a} - 1", "{a} - 1"),
    "next": Text("{a} + 1", "{a} + 1"),
    "last": Text("{a} - 1", "{a} - 1"),
    "neg": Text("-({a})", "-({a})"),
    "not": Text("{a}按位取反", "{a} with every bit inverted"),
    "sqrt": Text("{a}的平方根（取整）", "the whole square root of {a}"),
    "rsqrt": Text("{a}的平方根", "the square root of {a}"),
    "rem": Text("{a} ÷ {b}的余数", "the remainder of {a} ÷ {b}"),
    "to_real": Text("{a}化成实数", "{a} as a real number"),
    "round": Text("{a}四舍五入", "{a} rounded to a whole number"),
    "trunc": Text("{a}去掉小数部分", "{a} without its fraction"),
    "shl": Text("{a}左移{b}位", "{a} shifted left by {b}"),
    "shr": Text("{a}右移{b}位", "{a} shifted right by {b}"),
    "rol": Text("{a}循环左移{b}位", "{a} turned left by {b}"),
    "ror": Text("{a}循环右移{b}位", "{a} turned right by {b}"),
}
_MOVES = {"move", "fit", "to_real"}
_HALVES = {"mul16", "divmod"}
_QUOTIENTS = {"divmod", "parts"}
_BITWISE = {"and", "or", "xor", "not", "shl", "shr", "rol", "ror"}
_TURNS = {"shl", "shr", "rol", "ror"}
_ROOTS = {"sqrt", "rsqrt"}
_FLAGS = {
    "zero": Text("结果为0", "the result is 0"),
    "overflow": Text("溢出", "overflow"),
    "negative": Text("结果为负", "the result is negative"),
    "borrow": Text("借位", "borrow"),
    "carry": Text("进位", "carry"),
    "divide": Text("除数为0", "division by zero"),
    "out": Text("最后移出的位", "the last bit that fell out"),
}
_WIDE = 16


@dataclass(frozen=True, slots=True)
class _Job:
    """One word to be worked out: its rule, where it goes, and what it is made of, each with its kind."""

    op: str
    target: Address
    kind: Kind
    sources: tuple[tuple[Arg, Kind], ...]


def works(told: Told, verb: Verb) -> Text:
    """Say what a word is worked out of, and with values what came of it."""
    job = _job(told, verb)
    if job is None:
        return NOTHING
    if job.op == "compare":
        return _ordered(told, verb, job)
    target, power = same(job.target.text), fired(told, verb)
    plainly = Text("{target} := {formula}", "{target} := {formula}").format(target=target, formula=_formula(told, job))
    if not told.step or power == "x":
        keeps = Text(f"{job.target.text}不变", f"{job.target.text} keeps its value")
        return when(told, verb, plainly, keeps)
    left = told.written
    stays = _shown(told, told.step.written[0][1].value, job) if left else ""
    keeps = Text(f"{job.target.text}保持{stays}", f"{job.target.text} keeps {stays}")
    now = Text(f"{job.target.text}现在是{stays}", f"{job.target.text} is {stays} now")
    return when(told, verb, _came(told, job), keeps, now)


def _job(told: Told, verb: Verb) -> _Job | None:
    """Find out what a line works out: from its operands, or from its expression in brackets."""
    arg, kinds = told.line.bound.get(verb.target), told.dialect.kinds
    if isinstance(arg, Assign):
        return _Job(
            arg.op.rstrip("0123456789"),
            arg.target,
            kinds[arg.kind],
            tuple((one, kinds[arg.kind]) for one in arg.sources),
        )
    named = {operand.name: operand for operand in told.line.insn.operands}
    sources = tuple(
        (told.line.bound[name], kinds[named[name].kind]) for name in verb.sources if name in told.line.bound
    )
    if not isinstance(arg, Address):
        return None
    op = verb.op if verb.op in _SIGNS | _SAID else verb.op.rstrip("0123456789")
    return _Job(op, arg, kinds[named[verb.target].kind], sources)


def _formula(told: Told, job: _Job) -> Text:
    """Spell what is worked out, in addresses and constants."""
    parts = [same(arg.text if not isinstance(arg, int) else str(arg)) for arg, _ in job.sources]
    if job.op in _HALVES:
        parts[0] = Text(f"{parts[0].zh}的低字", f"(the low word of {parts[0].en})")
    if job.op == "fit":
        return Text("{a}（放得下时）", "{a} (if it fits)").format(a=parts[0])
    said = _spelled(job.op, parts)
    if job.op in _QUOTIENTS:
        low, high = _halves(told, job)
        return Text(
            "{said}（商在{low}，余数在{high}）", "{said} (the quotient in {low}, the remainder in {high})"
        ).format(said=said, low=low, high=high)
    return said


def _spelled(op: str, parts: list[Text]) -> Text:
    if op in _SIGNS:
        return joined(parts, f" {_SIGNS[op]} ", f" {_SIGNS[op]} ")
    values = dict(zip("ab", parts, strict=False))
    return _SAID.get(op, Text("{a}", "{a}")).format(**values)


def _halves(told: Told, job: _Job) -> tuple[Text, Text]:
    """Name the two halves of a double word: its low and high word, or two registers."""
    area = told.dialect.area(job.target)
    if area.words or not area.holds(job.target.index + 1):
        return Text("低字", "the low word"), Text("高字", "the high word")
    return same(job.target.text), same(area.address(job.target.index + 1).text)


def _came(told: Told, job: _Job) -> Text:
    """Say with numbers what was worked out, whether it fitted, and which flags are 1."""
    step = told.step
    if step is None or not step.written:
        return NOTHING
    values, result = _values(told, job), step.written[0][1].value
    shown, flags = _shown(told, result, job), _raised(told, job)
    parts = [same(_one(told, value, kind, job)) for value, (_, kind) in zip(values, job.sources, strict=True)]
    if job.op in _TURNS:
        parts[1] = same(str(values[1]))
    said = same(shown) if job.op in _MOVES else _spelled(job.op, parts)
    trouble = _trouble(told, job, values) if repr(dict(step.kept).get("ENO", "1")) == "0" else None
    if trouble:
        kept = Text("，但{why}，{target}保持{shown}", "; {why}, so {target} keeps {shown}")
        kept = kept.format(why=trouble, target=job.target.text, shown=shown)
        return joined(
            [Text("要算{said}{kept}", "{said} is wanted{kept}").format(said=said, kept=kept), *flags], "，", ", "
        )
    if job.op not in _MOVES:
        said = Text("{said} = {shown}", "{said} = {shown}").format(said=said, shown=_result(told, result, job))
    cut = []
    if repr(dict(step.kept).get("ENO", "1")) == "0":
        cut = [Text("结果太大，高位被截去", "the result is too large and is cut off")]
    return joined(
        [Text("{t} := {said}", "{t} := {said}").format(t=job.target.text, said=said), *cut, *flags], "，", ", "
    )


def _result(told: Told, result: int | None, job: _Job) -> Text:
    """Write a result: two halves where it is a quotient with its remainder."""
    if job.op not in _QUOTIENTS or result is None:
        number = _shown(told, result, job)
        plain = "" if result is None or job.op not in _BITWISE or job.kind.size > _WIDE else f" ({result})"
        return Text(number + plain.replace(" (", "（").replace(")", "）"), number + plain)
    low, high = wrapped(result, _WIDE), wrapped(result >> _WIDE, _WIDE)
    return Text(f"{low}，余{high}", f"{low}, remainder {high}")


def _trouble(told: Told, job: _Job, values: list[Any]) -> Text | None:
    """Say why nothing was written, if nothing was."""
    if RULES[_full(job)].divides and values[-1] == 0:
        return Text("除数为0", "nothing can be divided by 0")
    if job.op in _ROOTS and values[0] is not None and values[0] < 0:
        return Text("负数没有平方根", "a negative number has no square root")
    if told.dialect.wraps:
        return None
    return Text("结果放不下", "the result does not fit")


def _full(job: _Job) -> str:
    return job.op if job.op in RULES else f"{job.op}{job.kind.size}"


def _values(told: Told, job: _Job) -> list[Any]:
    """Give the numbers that were read, in the order of the operands; a constant is its own."""
    reads = iter(value for place, value in told.step.read if isinstance(place, Address)) if told.step else iter(())
    found: list[Any] = []
    for arg, _ in job.sources:
        word: Any = next(reads, None) if isinstance(arg, Address) else arg
        number = word.number if isinstance(word, Value) else getattr(word, "value", word)
        found.append(number)
    if job.op in _HALVES and found[0] is not None:
        found[0] = wrapped(found[0], _WIDE)
    return found


def _one(told: Told, value: float | None, kind: Kind, job: _Job) -> str:
    """Write one number as its operation wants it: a real, a row of bits, or a plain number."""
    if value is None:
        return "x"
    if kind.real:
        number = value if isinstance(value, float) else real(int(value))
        said = f"{number:.7g}"
        return said if set(said) & set(".en") else f"{said}.0"
    if job.op in _BITWISE and kind.size == job.kind.size:
        return bits_of(told, int(value), kind.size)
    return str(value)


def _shown(told: Told, value: int | None, job: _Job) -> str:
    return _one(told, value, job.kind, job)


def bits_of(told: Told, value: int, size: int) -> str:
    """Write a word bit by bit in groups of four, a long one in base 16 as the family spells it."""
    value &= (1 << size) - 1
    if size > _WIDE:
        letters = next(letters for letters, base in told.dialect.constant.items() if base == _WIDE)
        return f"{letters}{value:0{size // 4}X}"
    said = f"{value:0{size}b}"
    return " ".join(said[place : place + 4] for place in range(0, size, 4))


def _raised(told: Told, job: _Job) -> list[Text]:
    """Tell of the flags that are 1, and of the bit that fell out."""
    named = _named_flags(told, job)
    found = []
    for place, bit in told.step.written[1:] if told.step else ():
        if place.text in named and repr(bit) == "1":
            said = Text("{flag}为1（{what}）", "{flag} is 1 ({what})")
            found.append(said.format(flag=place.text, what=named[place.text]))
    return found


def _named_flags(told: Told, job: _Job) -> dict[str, Text]:
    """Give the flags that an operation leaves, by address, with what each says."""
    rule, flags = RULES[_full(job)], told.dialect.flags
    named: dict[str, Text] = {}
    for name in rule.flags:
        if name in flags:
            before = named.get(flags[name])
            named[flags[name]] = joined([before, _FLAGS[name]], "或", " or ") if before else _FLAGS[name]
    place = flags.get("out", flags.get("overflow"))
    if rule.out and place:
        named[place] = _FLAGS["out"]
    return named


def flags(told: Told, verb: Verb) -> Text:
    """Say on a card which flags an operation writes as well."""
    job = _job(told, verb) if verb.name == "work" else None
    named = _named_flags(told, job) if job and job.op != "compare" else {}
    each = [Text("{flag}（{what}）", "{flag} ({what})").format(flag=flag, what=what) for flag, what in named.items()]
    if not each:
        return NOTHING
    return Text("标志：{each}", "Flags: {each}").format(each=joined(each, "、", ", "))


def _ordered(told: Told, verb: Verb, job: _Job) -> Text:
    """Tell of three bits that say where a word lies."""
    places = [place.text for place in told.dialect.following(job.target, 3)]
    first, *rest = (arg.text if not isinstance(arg, int) else str(arg) for arg, _ in job.sources)
    value = rest[-1]
    holds = [f"{first} > {value}", f"{first} = {value}", f"{first} < {value}"]
    if len(rest) > 1:
        holds = [f"{value} < {first}", f"{first} ≤ {value} ≤ {rest[0]}", f"{value} > {rest[0]}"]
    named, stay = "、".join(places), ", ".join(places)
    keeps = Text(f"{named}不变", f"{stay} stay as they are")
    if not told.step or fired(told, verb) == "x":
        said = Text(f"{named}分别表示{'、'.join(holds)}是否成立", f"{stay} say whether {', '.join(holds)}")
        return when(told, verb, said, keeps)
    values = zip((arg for arg, _ in job.sources), _values(told, job), strict=True)
    seen = [f"{arg.text} = {'x' if number is None else number}" for arg, number in values if isinstance(arg, Address)]
    bits = [repr(bit) for _, bit in told.step.written]
    true = [hold for hold, bit in zip(holds, bits, strict=False) if bit == "1"]
    each = same(", ".join(f"{place} = {bit}" for place, bit in zip(places, bits, strict=False)))
    now = (
        Text("{seen}，{true}；{each}", "{seen} and {true}, so {each}")
        if true
        else Text("{seen}；{each}", "{seen}; {each}")
    )
    said = now.format(seen=same(", ".join(seen)), true=same(true[0] if true else ""), each=each)
    if fired(told, verb) == "":
        said = each
    return when(told, verb, said, keeps, each)


def shifts(told: Told, verb: Verb) -> Text:
    """Tell of a row of bits: what enters, where it moves, what falls out."""
    shift = shift_of(told.dialect, told.line, verb)
    if shift is None:
        return NOTHING
    row = [place.text for place in shift.row] or [told.address(verb.target)]
    moves = _row(told, verb, (row, [place.text for place in shift.entering]), up=shift.up)
    bits = " ".join(repr(bit) for _, bit in told.step.written[: len(row)]) if told.step else ""
    stand = Text("{row}现在是{bits}", "{row} are {bits} now").format(row=_span(row), bits=bits) if bits else NOTHING
    still = joined([Text("各位不动", "no bit moves"), stand], "，", ", ")
    return when(told, verb, joined([moves, stand], "；", "; "), still, stand)


def _row(told: Told, verb: Verb, bits: tuple[list[str], list[str]], *, up: bool) -> Text:
    """Say which bits enter a row, and which fall out of it."""
    row, entering = bits
    count = len(entering)
    into, out = (row[:count], row[-count:]) if up else (row[-count:], row[:count])
    flag = told.dialect.flags.get("overflow", "") if verb.op == "row" else ""
    seen = [repr(bit) for _, bit in told.step.read] if told.step else []
    said = Text(
        "{row}{way}移{count}位：{data}进入{into}，{out}原来的值移出{flag}",
        "{row} move {count} {place} {way}: {data} {enter} at {into}, and what stood in {out} falls out{flag}",
    )
    one = count == 1
    return said.format(
        row=_span(row), count=count, way=Text("向高位" if up else "向低位", "up" if up else "down"),
        data=with_value(_span(entering), " ".join(seen)), into=_span(into), out=_span(out),
        place="place" if one else "places", enter="enters" if one else "enter",
        flag=Text(f"到{flag}", f" into {flag}") if flag else NOTHING,
    )  # fmt: skip


def _span(names: list[str]) -> Text:
    """Name a stretch by its ends."""
    return same(names[0]) if len(names) == 1 else Text(f"{names[0]}到{names[-1]}", f"{names[0]} to {names[-1]}")
