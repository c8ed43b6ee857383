"""Random ladders for the tests, in the words of any family, and a small evaluator that shares nothing with the package's own."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from hypothesis import strategies as st

from plcteach.core.ladder import Branch, Coil, Contact, Invert, Ladder, Series, branch, parallel, rung, series

if TYPE_CHECKING:
    from plcteach.core.ladder import Node, Out, Rung

FAMILIES = {"s7-200": ("I0.", "Q0."), "gutta": ("I0.", "Q0."), "fx": ("X", "Y"), "neza": ("%I0.", "%Q0.")}
INPUTS, OUTPUTS = 4, 3


def bits(family: str) -> tuple[list[str], list[str]]:
    """Give the inputs and the outputs that random ladders of a family use."""
    i, q = FAMILIES[family]
    return [f"{i}{number}" for number in range(INPUTS)], [f"{q}{number}" for number in range(OUTPUTS)]


@cache
def nodes(family: str, *, edges: bool = False) -> st.SearchStrategy[Node]:
    """Draw contacts in series and in parallel, some of them of outputs, so that rungs seal themselves in."""
    inputs, outputs = bits(family)
    contacts: st.SearchStrategy[Node] = st.builds(Contact, st.sampled_from(inputs + outputs), st.booleans())
    if edges:
        contacts |= st.builds(Contact, st.sampled_from(inputs), st.just(value=False), st.sampled_from(["rise", "fall"]))

    def grown(inner: st.SearchStrategy[Node]) -> st.SearchStrategy[Node]:
        some = st.lists(inner, min_size=2, max_size=3)
        return some.map(lambda parts: series(*parts)) | some.map(lambda parts: parallel(*parts))

    return st.recursive(contacts, grown, max_leaves=7)


@cache
def outs(family: str, *, edges: bool = False, turned: bool = False) -> st.SearchStrategy[list[Out]]:
    """Draw what hangs on a node: coils, and branches up to three levels deep."""
    coils: st.SearchStrategy[Out] = st.builds(
        Coil, st.sampled_from(bits(family)[1]), st.sampled_from(["", "", "set", "reset", "not"])
    )
    stems = nodes(family, edges=edges)
    if turned:
        stems |= stems.map(lambda node: series(node, Invert()))

    def grown(inner: st.SearchStrategy[Out]) -> st.SearchStrategy[Out]:
        return st.builds(lambda stem, some: branch(stem, *some), stems, st.lists(inner | coils, min_size=1, max_size=3))

    return st.lists(st.recursive(coils, grown, max_leaves=4), min_size=1, max_size=3)


@cache
def rungs(family: str, *, edges: bool = False, turned: bool = False) -> st.SearchStrategy[Rung]:
    """Draw a rung in its plain form."""
    stems = nodes(family, edges=edges)
    if turned:
        stems |= stems.map(lambda node: series(node, Invert()))
    return st.builds(lambda stem, some: rung(stem, *some), stems, outs(family, edges=edges, turned=turned))


@cache
def ladders(family: str, *, edges: bool = False, turned: bool = False) -> st.SearchStrategy[Ladder]:
    """Draw one or two rungs."""
    return st.lists(rungs(family, edges=edges, turned=turned), min_size=1, max_size=2).map(
        lambda some: Ladder(tuple(some))
    )


class Plain:
    """One scan after another over plain truth values."""

    def __init__(self) -> None:
        self.bits: dict[str, bool] = {}
        self.last: dict[str, bool] | None = None

    def scan(self, ladder: Ladder, inputs: dict[str, bool]) -> dict[str, bool]:
        """Work out one scan and give the bits after it; an edge looks at the inputs of the scan before."""
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
            elif out.kind in {"set", "reset"}:
                if flow:
                    self.bits[out.address] = out.kind == "set"
            else:
                self.bits[out.address] = flow if out.kind == "" else not flow

    def through(self, node: Node, *, flow: bool) -> bool:
        if isinstance(node, Invert):
            return not flow
        if isinstance(node, Contact):
            return flow and self.closed(node)
        if isinstance(node, Series):
            for part in node.parts:
                flow = self.through(part, flow=flow)
            return flow
        return any(self.through(part, flow=flow) for part in node.parts)

    def closed(self, contact: Contact) -> bool:
        now = self.bits.get(contact.address, False)
        if contact.edge:
            return self.last is not None and now != self.last[contact.address] and now == (contact.edge == "rise")
        return now != contact.negated
