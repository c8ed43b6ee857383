"""Random ladders for the tests, in the words of any family, and a small evaluator that shares nothing with the package's own."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from hypothesis import strategies as st

from plcteach.core.ladder import (
    Box,
    Branch,
    Coil,
    Compared,
    Contact,
    Edge,
    Invert,
    Ladder,
    Parallel,
    Rung,
    Series,
    branch,
    parallel,
    rung,
    series,
)

if TYPE_CHECKING:
    from plcteach.core.ladder import Node, Out

FAMILIES = {"s7-200": ("I0.", "Q0."), "gutta": ("I0.", "Q0."), "fx": ("X", "Y"), "neza": ("%I0.", "%Q0.")}
INPUTS, OUTPUTS = 4, 3

COMPARED = (
    "VW0", "MB4", "%MW0", "%DR0.S", "%TM0.V", "D0", "T0", "C0", "K4M0", "AC0", "温度",
    "5", "-3", "+88", "16#1F", "16#-5", "2#1010", "3.14", "-1.5E+16", "1E-05", "K5", "K-5", "H1F",
)  # fmt: skip
"""What the lists of the four families compare."""

BOXES = (
    "TON T37, 50",
    "MOVB 16#FF, VB0",
    "INC %MW0",
    "[%MW0 := %MW1 + 5]",
    "OUT T0 K30",
    "MOV K5 D0",
    "IN %TM0",
    "+I AC0, AC1",
)
COUNTERS = (
    ("CTU C0, 3", "CU", ("R",)),
    ("CTUD C48, +5", "CU", ("CD", "R")),
    ("BLK %C0", "", ("R", "S1")),
    ("SR 1", "", ()),
)
LABELS = ("LBL 1", "NEXT", "%L1:", "SR0:", "STL S20")
TITLES = ("", "启动", "电动机 start", "第2级：延时（3s）", "a - b")


def bits(family: str) -> tuple[list[str], list[str]]:
    """Give the inputs and the outputs that random ladders of a family use."""
    i, q = FAMILIES[family]
    return [f"{i}{number}" for number in range(INPUTS)], [f"{q}{number}" for number in range(OUTPUTS)]


@cache
def nodes(family: str, *, edges: bool = False, every: bool = False) -> st.SearchStrategy[Node]:
    """Draw contacts in series and in parallel, some of them of outputs, so that rungs seal themselves in.

    every: all symbols that can be drawn, also those of other families, which not every part of the package can follow.
    """
    inputs, outputs = bits(family)
    contacts: st.SearchStrategy[Node] = st.builds(Contact, st.sampled_from(inputs + outputs), st.booleans())
    if edges or every:
        contacts |= st.builds(Contact, st.sampled_from(inputs), st.just(value=False), st.sampled_from(["rise", "fall"]))
    if every:
        words = st.sampled_from(COMPARED)
        relations = st.sampled_from(["=", "<>", ">=", "<=", ">", "<"])
        contacts |= st.builds(Contact, st.sampled_from(inputs), st.booleans(), st.just(""), st.just(value=True))
        contacts |= st.builds(Compared, words, relations, words, st.sampled_from(["", "B", "D", "R"]))
        contacts |= st.builds(Edge, st.booleans(), st.sampled_from(["", "M0.0", "%M3"])) | st.just(Invert())

    def grown(inner: st.SearchStrategy[Node]) -> st.SearchStrategy[Node]:
        some = st.lists(inner, min_size=2, max_size=3)
        return some.map(lambda parts: series(*parts)) | some.map(lambda parts: parallel(*parts))

    return st.recursive(contacts, grown, max_leaves=7)


@cache
def outs(
    family: str, *, edges: bool = False, turned: bool = False, every: bool = False
) -> st.SearchStrategy[list[Out]]:
    """Draw what hangs on a node: coils (and boxes of one input), and branches up to three levels deep."""
    addresses = st.sampled_from(bits(family)[1])
    coils: st.SearchStrategy[Out] = st.builds(Coil, addresses, st.sampled_from(["", "", "set", "reset", "not"]))
    if every:
        counted = st.sampled_from(["set", "reset"]), st.integers(1, 255), st.booleans()
        coils |= st.builds(Coil, addresses, *counted) | st.builds(Coil, addresses, st.sampled_from(["rise", "fall"]))
        coils |= addresses.map(lambda address: Coil(address, immediate=True)) | st.sampled_from(BOXES).map(Box)
    stems = nodes(family, edges=edges, every=every)
    if turned:
        stems |= stems.map(lambda node: series(node, Invert()))

    def grown(inner: st.SearchStrategy[Out]) -> st.SearchStrategy[Out]:
        return st.builds(lambda stem, some: branch(stem, *some), stems, st.lists(inner | coils, min_size=1, max_size=3))

    return st.lists(st.recursive(coils, grown, max_leaves=4), min_size=1, max_size=3)


@cache
def ends(family: str) -> st.SearchStrategy[Out]:
    """Draw a box of several inputs, on the rung's first node or behind branches, where it is the last output."""
    stems = nodes(family, every=True)

    def counter(kind: tuple[str, str, tuple[str, ...]]) -> st.SearchStrategy[Out]:
        text, entry, names = kind
        return st.tuples(*(stems for _ in names)).map(
            lambda some: Box(text, tuple(zip(names, some, strict=True)), entry)
        )

    def grown(inner: st.SearchStrategy[Out]) -> st.SearchStrategy[Out]:
        before = outs(family, every=True) | st.just([])
        return st.builds(lambda stem, some, end: branch(stem, *some, end), stems, before, inner)

    return st.recursive(st.sampled_from(COUNTERS).flatmap(counter), grown, max_leaves=2)


@cache
def rungs(family: str, *, edges: bool = False, turned: bool = False, every: bool = False) -> st.SearchStrategy[Rung]:
    """Draw a rung in its plain form."""
    stems = nodes(family, edges=edges, every=every)
    if turned:
        stems |= stems.map(lambda node: series(node, Invert()))
    some = outs(family, edges=edges, turned=turned, every=every)
    if not every:
        return st.builds(lambda stem, some: rung(stem, *some), stems, some)
    whole = st.builds(lambda stem, some, end: rung(stem, *some, end), stems, some | st.just([]), ends(family))
    plain = st.builds(lambda stem, some, title: rung(stem, *some, title=title), stems, some, st.sampled_from(TITLES))
    labels = st.builds(lambda text: rung(None, Box(text)), st.sampled_from(LABELS))
    return plain | whole | whole | labels | ends(family).map(lambda end: rung(None, end))


@cache
def ladders(
    family: str, *, edges: bool = False, turned: bool = False, every: bool = False
) -> st.SearchStrategy[Ladder]:
    """Draw one or two rungs."""
    return st.lists(rungs(family, edges=edges, turned=turned, every=every), min_size=1, max_size=2).map(
        lambda some: Ladder(tuple(some))
    )


WORDS = {"s7-200": ("VW0", ""), "gutta": ("VW0", ""), "fx": ("D0", "K"), "neza": ("%MW0", "")}
"""A word of each family, and what stands before a number."""


def enriched(ladder: Ladder, family: str, data: st.DataObject, *, words: bool = True) -> Ladder:  # noqa: C901
    """Put edges on the wire for some NOTs, NOT into parallel paths, comparisons for some contacts, and pulse coils."""
    count = 0
    word, mark = WORDS[family]

    def chance(most: int) -> bool:
        return data.draw(st.integers(0, most)) == 0

    def edge() -> Edge:
        nonlocal count
        count += 1
        return Edge(data.draw(st.booleans()), f"M{1 + count // 8}.{count % 8}" if family == "gutta" else "")

    def node(one: Node, *, inside: bool = False) -> Node:
        if isinstance(one, Series):
            return series(node(one.parts[0], inside=inside), *(node(part, inside=True) for part in one.parts[1:]))
        if isinstance(one, Parallel):
            paths = [node(part, inside=inside) for part in one.parts]
            if inside and chance(2):
                paths[0] = series(paths[0], Invert() if family == "neza" or chance(1) else edge())
            return parallel(*paths)
        if isinstance(one, Invert) and family != "neza" and chance(1):
            return edge()
        if words and isinstance(one, Contact) and not one.edge and chance(5):
            relation = data.draw(st.sampled_from(["=", "<>", ">=", "<=", ">", "<"]))
            return Compared(word, relation, f"{mark}{data.draw(st.integers(0, 3))}")
        return one

    def out(one: Out) -> Out:
        if isinstance(one, Branch):
            return Branch(node(one.stem, inside=True), tuple(map(out, one.outs)))
        if family in {"s7-200", "fx"} and isinstance(one, Coil) and not one.kind and chance(3):
            return Coil(one.address, data.draw(st.sampled_from(["rise", "fall"])))
        return one

    return Ladder(tuple(Rung(node(one.stem), tuple(map(out, one.outs))) for one in ladder.rungs if one.stem))


_RELATIONS = {
    "=": int.__eq__, "<>": int.__ne__, ">=": int.__ge__, "<=": int.__le__, ">": int.__gt__, "<": int.__lt__,
}  # fmt: skip


class Plain:
    """One scan after another over plain truth values; edges of the flow are told apart by their place in the scan."""

    def __init__(self) -> None:
        self.bits: dict[str, bool] = {}
        self.last: dict[str, bool] | None = None
        self.words: dict[str, int] = {}
        self.flows: dict[int, bool] = {}
        self.place = 0

    def changed(self, flow: bool, *, rising: bool, first: bool | None = None) -> bool:  # noqa: FBT001
        self.place += 1
        before = self.flows.get(self.place, first)
        self.flows[self.place] = flow
        return before is not None and flow != before and flow == rising

    def scan(self, ladder: Ladder, inputs: dict[str, bool]) -> dict[str, bool]:
        """Work out one scan and give the bits after it; an edge looks at the inputs of the scan before."""
        self.place = 0
        self.bits.update(inputs)
        self.inputs = inputs
        for one in ladder.rungs:
            assert one.stem is not None
            self.hang(one.outs, self.through(one.stem, flow=True))
        self.last = inputs
        return dict(self.bits)

    def hang(self, some: tuple[Out, ...], flow: bool) -> None:  # noqa: FBT001
        for out in some:
            if isinstance(out, Branch):
                self.hang(out.outs, self.through(out.stem, flow=flow))
            elif out.kind in {"rise", "fall"}:
                self.bits[out.address] = self.changed(flow, rising=out.kind == "rise")
            elif out.kind in {"set", "reset"}:
                if flow:
                    self.bits[out.address] = out.kind == "set"
            else:
                self.bits[out.address] = flow if out.kind == "" else not flow

    def through(self, node: Node, *, flow: bool) -> bool:
        if isinstance(node, Invert):
            return not flow
        if isinstance(node, Edge):
            return self.changed(flow, rising=node.rising, first=False if node.memory else None)
        if isinstance(node, Compared):
            return flow and _RELATIONS[node.relation](self.words[node.left], int(node.right.strip("K")))
        if isinstance(node, Contact):
            return flow and self.closed(node)
        if isinstance(node, Series):
            for part in node.parts:
                flow = self.through(part, flow=flow)
            return flow
        flows = [self.through(part, flow=flow) for part in node.parts]
        return any(flows)

    def closed(self, contact: Contact) -> bool:
        now = self.bits.get(contact.address, False)
        if contact.edge:
            return self.last is not None and now != self.last[contact.address] and now == (contact.edge == "rise")
        return now != contact.negated
