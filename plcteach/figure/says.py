"""One sentence on what an instruction did, or does: told from its formulas and its flow, never from its name."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from plcteach.core.effect import Both, Edge, Name, flow, names
from plcteach.core.program import Compare
from plcteach.core.text import NOTHING, Text, joined
from plcteach.figure.does import does
from plcteach.figure.illustration import beyond_bits, example, takes_of
from plcteach.figure.told import Told, edge_seen, operand_name, operand_said, plain, side, stack_name, with_value
from plcteach.figure.works import flags
from plcteach.figure.writes import besides, writes

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.effect import Formula, Origin
    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect
    from plcteach.core.verb import Verb
    from plcteach.machine.signals import Column
    from plcteach.machine.step import Step

_OPERATORS = {"&": Text("相与", "AND"), "|": Text("相或", "OR"), "^": Text("相异或", "XOR")}
_SPARE = 2


def says(dialect: Dialect, step: Step[Column], *, first: bool = False) -> Text:
    """Say what a step did, for the player; `first`: it belongs to the first scan, in which there are no edges."""
    return _sentence(step.line.text, _parts(Told(dialect, step.line, step.flow, step, first)))


def describes(dialect: Dialect, insn: Insn) -> Text:
    """Say what an instruction does, for its card: the same sentence with names where a step has values."""
    line = example(dialect, insn.mnemonic)
    heights = tuple(
        stack.depth if stack.fixed or "[" in line.effect.text else len(takes_of(line.effect, stack.name)) + _SPARE
        for stack in dialect.stacks
    )
    named = beyond_bits(dialect, insn)
    told = Told(dialect, line, flow(line.effect, dialect.shapes, heights), named=named)
    head = line.text if named or "[" in line.effect.text else insn.mnemonic
    return _sentence(head, [*_parts(told), *_otherwise(told)])


def _otherwise(told: Told) -> Iterator[Text]:
    """Tell of the other readings that an instruction has, and of its flags."""
    insn = told.line.insn
    yield from (flags(told, verb) for verb in insn.then)
    yield from (besides(told, verb) for verb in insn.then)
    if insn.fresh:
        yield Text("在新电路的开头，什么也不压入", "At the start of a new circuit nothing is pushed")
    if insn.bare:
        yield Text(
            "不带操作数时，下一条指令装载这一块的第一个触点",
            "Without an operand, the next instruction loads the block's first contact",
        )
    closers = {row.close: row.mnemonic for row in reversed(told.dialect.insns) if row.close}
    for effect, opener in closers.items() if insn.effect in closers else ():
        formula = effect.clauses[0].gives[0].formula
        if effect != insn.effect and isinstance(formula, Both):
            yield Text("由{opener}打开时则{op}", "Where {opener} has opened it, it is {op}").format(
                opener=opener, op=_OPERATORS[formula.op]
            )


def _sentence(head: str, parts: Iterator[Text] | list[Text]) -> Text:
    """Put sentences, each without its full stop, behind the instruction they are about."""
    head = head.rstrip(":")
    kept = [part for part in parts if part.zh]
    zh = "".join(f"{part.zh}。" for part in kept)
    en = ". ".join(
        part.en if part.en.startswith(head) or not number else part.en[:1].upper() + part.en[1:]
        for number, part in enumerate(kept)
    )
    return Text(f"{head}：{zh}", f"{head}: {en}.")


def _parts(told: Told) -> Iterator[Text]:
    yield from _missing(told)
    if not _changes(told):
        yield from _unchanged(told)
        return
    yield from _saved(told)
    top = told.flow.after[0][0] if told.flow.after[0] else None
    if top and top.how == "made" and top.formula is not None:
        yield from _made(told, top.formula)
    elif top and top.how == "blank":
        yield Text(
            "新的一块从这里开始，{it}暂时为x", "A new block begins here; until its first contact {it} is x"
        ).format(it=told.result)
    elif top:
        yield from _moved(told, top)
    yield from _lost(told)
    yield from (_beside(told, verb) for verb in told.line.insn.then)


def _changes(told: Told) -> bool:
    stays = all(
        one.how == "kept" and one.sources == ((number, place),)
        for number, cells in enumerate(told.flow.after)
        for place, one in enumerate(cells)
    )
    return not stays or bool(told.flow.dropped or told.flow.merged)


def _missing(told: Told) -> Iterator[Text]:
    for stack, count in zip(told.dialect.stacks, told.flow.missing, strict=True):
        if count:
            lack = Text(
                f"{stack.title.zh}里少{count}个值",
                f"the {stack_name(stack).en} is {count} value{'s' if count > 1 else ''} short",
            )
            yield Text("{lack}，用x代替", "{lack}, and x stands in").format(lack=lack)


def _unchanged(told: Told) -> Iterator[Text]:
    """Tell of coils, blocks and words, and of instructions that do nothing to any stack."""
    verbs = [one for one in map(partial(_beside, told), told.line.insn.then) if one.zh]
    alone = Text("累加器不变", "the accumulator keeps its value")
    stays = Text("堆栈不变", "the stack stays as it is") if told.main.depth > 1 else alone
    if "call" in told.line.insn.does:
        stays = NOTHING
    if not verbs:
        yield Text("空操作，什么也不改变", "no operation, and nothing changes")
        return
    yield from verbs[:-1]
    taken = any(clause.takes for clause in told.line.effect.clauses)
    whole = Text("{does}；{stays}", "{does}; {stays}").format(does=verbs[-1], stays=stays)
    yield whole if taken and stays.zh else verbs[-1]


def _beside(told: Told, verb: Verb) -> Text:
    """Tell what an instruction does beside the stack."""
    return writes(told, verb) if verb.name in _BITS else does(told, verb)


_BITS = {"coil", "set", "reset"}


def _saved(told: Told) -> Iterator[Text]:
    """Tell what goes onto another stack."""
    for number, stack in enumerate(told.dialect.stacks):
        for one in told.flow.after[number] if number else ():
            if one.sources and one.sources[0][0] != number:
                put = (
                    Text("复制一份压入{stack}", "is copied onto the {stack}")
                    if one.how == "copied"
                    else Text("压入{stack}", "is saved on the {stack}")
                )
                yield Text("{it}{put}", "{it} {put}").format(
                    it=told.cell(one.sources[0]), put=put.format(stack=stack_name(stack))
                )


def _made(told: Told, formula: Formula) -> Iterator[Text]:
    """Tell of a new result: a load, an operation in place, or a join."""
    operands = names(formula) & set(told.line.bound)
    if not names(formula) & set(told.flow.named):
        yield from _loaded(told, formula) if operands else [Text("{it}变为x", "{it} becomes x").format(it=told.result)]
        return
    said = operand_said(told, formula) if operands and not plain(told, formula) else None
    yield said or NOTHING
    yield _with_moves(told, _operation(told, formula))


def _operation(told: Told, formula: Formula) -> Text:
    value = told.value
    match formula:
        case Both(op, left, right):
            goes = (
                Text("送入{it}", "goes into {it}").format(it=told.result)
                if told.main.register
                else Text("成为新的栈顶", "becomes the new top")
            )
            result = Text(f"得{value}，", f" = {value}") if value else Text("的结果", "")
            said = Text("{a}与{b}{op}{result}{goes}", "{a} {op} {b}{result} {goes}")
            return said.format(
                a=side(told, left, op), b=side(told, right, op), op=_OPERATORS[op], result=result, goes=goes
            )
        case Edge(rising, _) if value:
            why = edge_seen(told, told.cell(), value, rising=rising)
            return Text("{why}，{it}变为{value}", "{why}, so {it} becomes {value}").format(
                why=why, it=told.result, value=value
            )
        case Edge(rising, _):
            turn = Text("由0变1" if rising else "由1变0", "risen" if rising else "fallen")
            said = Text(
                "{it}自上次扫描以来{turn}时变为1，否则变为0",
                "{it} becomes 1 if it has {turn} since the last scan, and 0 otherwise",
            )
            return said.format(it=told.result, turn=turn)
    got = Text(f"得{value}", f" to {value}") if value else NOTHING
    return Text("{it}取反{got}", "{it} is inverted{got}").format(it=told.cell(), got=got)


def _loaded(told: Told, formula: Formula) -> Iterator[Text]:
    """Tell of a load: where the bit goes, and where what was there goes."""
    to = (
        Text("送入{it}", "goes into {it}").format(it=told.result)
        if told.main.register
        else Text("压入栈顶", "is pushed onto the top")
    )
    said = operand_said(told, formula)
    what = operand_name(told, formula) if said is None else NOTHING
    if said is not None and any(isinstance(arg, Compare) for arg in told.line.args):
        to = Text(f"{said.zh}，{told.value}{to.zh}", f"{said.en}, so {told.value} {to.en}")
    elif said is not None and isinstance(formula, Name):
        to = Text(f"{said.zh}，{to.zh}", f"{said.en}. It {to.en}")
    elif said is not None:
        link = ", so" if isinstance(formula, Edge) else ", and"
        to = Text(
            f"{said.zh}，{told.value if isinstance(formula, Edge) else ''}{to.zh}",
            f"{said.en}{link} {told.value} {to.en}",
        )
    else:
        to = Text(f"{what.zh}{to.zh}", f"{what.en} {to.en}")
    yield (
        _with_moves(told, to)
        if not told.main.register
        else Text("{to}{old}", "{to}{old}").format(to=to, old=_replaced(told))
    )


def _replaced(told: Told) -> Text:
    """Say what becomes of the register's old value when a load takes its place."""
    cells = told.flow.after[0]
    old = with_value(NOTHING, told.was())
    if any(one.how == "kept" and one.sources == ((0, 0),) for one in cells[1:]):
        deeper = (
            Text("，下面各层依次下移一层", ", and the levels below move down one")
            if len(cells) > _WITH_DEEPER
            else NOTHING
        )
        return Text(
            "；原来的值{old}压入第1层{deeper}", "; the old value{old} is pushed down to level 1{deeper}"
        ).format(old=old, deeper=deeper)
    fresh = (
        Text("，开始一个新电路", ", and a new circuit begins") if told.line.effect == told.line.insn.fresh else NOTHING
    )
    if (0, 0) in told.flow.dropped and not fresh.zh:
        return Text("，取代原来的值{old}", ", in place of the old value{old}").format(old=old)
    return fresh


_WITH_DEEPER = 2


def _shift(told: Told) -> int:
    """Say by how many levels the cells below move down; negative is up, 0 for none."""
    cells = told.flow.after[0]
    moved = [
        place - one.sources[0][1] for place, one in enumerate(cells) if one.how == "kept" and one.sources[0][0] == 0
    ]
    return moved[-1] if moved else 0


def _with_moves(told: Told, said: Text) -> Text:
    """Add to a sentence what the other levels do."""
    cells, shift = told.flow.after[0], _shift(told)
    moves = Text("其余各层不变", "the other levels stay as they are")
    if shift:
        moves = Text("下面各层依次下移一层", "everything below moves down one level")
    if shift < 0:
        moves = Text("下面各层依次上移一层", "the levels below move up")
    if not any(one.how == "kept" and one.sources[0][0] == 0 for one in cells[1:]):
        moves = NOTHING
    enters = NOTHING
    if len(cells) > 1 and cells[-1].how == "blank":
        enters = Text("x补入{level}", "x enters {level}").format(level=told.main.level(len(cells) - 1))
    rest = joined((moves, enters), "，", " and ")
    return Text("{said}；{rest}", "{said}; {rest}").format(said=said, rest=rest) if rest.zh else said


def _moved(told: Told, top: Origin) -> Iterator[Text]:
    """Tell of pushes, reads and pops: a copy, or the cell below becoming the top."""
    source = top.sources[0]
    it, to = told.cell(source), told.result
    if source == (0, 0) and top.how == "kept":
        yield from (_pushed(told, it, place) for place, one in enumerate(told.flow.after[0]) if one.how == "copied")
        return
    old = (
        Text("，原来的值{v}消失", ", and the old value{v} is gone")
        if told.main.register
        else Text("，原栈顶{v}消失", ", and the old top{v} is gone")
    )
    gone = old.format(v=with_value(NOTHING, told.was())) if (0, 0) in told.flow.dropped else NOTHING
    if top.how == "copied":
        goes = (
            Text("复制一份压入栈顶", "is copied and pushed onto the top")
            if _shift(told) > 0
            else Text("复制到{to}", "is copied to {to}")
        )
    elif source[0] or told.main.register:
        goes = Text("弹出，送到{to}", "is popped and goes to {to}")
    else:
        goes = Text("成为新的栈顶", "becomes the new top")
    said = Text("{it}{goes}{gone}", "{it} {goes}{gone}").format(it=it, goes=goes.format(to=to), gone=gone)
    yield _with_moves(told, said)


def _pushed(told: Told, it: Text, place: int) -> Text:
    deeper = any(one.how == "kept" for one in told.flow.after[0][place + 1 :])
    moves = Text("，下面各层依次下移一层", ", and the levels below move down one") if deeper else NOTHING
    said = Text("{it}复制一份压入{level}{moves}", "{it} is copied into {level}{moves}")
    return said.format(it=it, level=told.main.level(place), moves=moves)


def _lost(told: Told) -> Iterator[Text]:
    """Tell what falls out at the bottom, unless it was only an x that had never meant anything."""
    for place in told.flow.lost:
        value = told.was(place)
        if value != "x":
            what = Text(f"的{value}" if value else "的值", f"the {value}" if value else "the value")
            said = Text("{level}{what}被推出栈底而丢失", "{what} in {level} falls out at the bottom and is lost")
            yield said.format(level=told.dialect.stacks[place[0]].level(place[1]), what=what)
