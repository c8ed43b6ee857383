"""Random instruction lists for the tests, sensible or not, in the words of any family; each family has three inputs here."""

from __future__ import annotations

from hypothesis import strategies as st

MENU = {
    "s7-200": (
        ["LD", "LDN", "A", "AN", "O", "ON"],
        ["ALD", "OLD", "LPS", "LRD", "LPP", "NOT", "EU", "ED", "LDS 1", "LDS 3"],
        ["= Q0.0", "= M0.0", "S Q0.1, 2", "R Q0.1, 1", "=I Q0.3", "LDI I0.1", "ANI I0.0", "= I0.2"],
        ["I0.0", "I0.1", "I0.2", "M0.0", "Q0.1", "SM0.1"],
    ),
    "fx": (
        ["LD", "LDI", "AND", "ANI", "OR", "ORI", "LDP", "LDF", "ANDP", "ORF"],
        ["ANB", "ORB", "MPS", "MRD", "MPP", "INV", "MEP", "MEF"],
        ["OUT Y0", "OUT M0", "SET Y1", "RST Y1", "PLS M1", "PLF M0", "END"],
        ["X0", "X1", "X2", "M0", "M1", "Y1", "M8002"],
    ),
    "neza": (
        ["LD", "LDN", "AND", "ANDN", "OR", "ORN", "XOR", "AND(", "OR(", "AND(N"],
        ["MPS", "MRD", "MPP", "N", ")", "LDR %I0.0", "ANDF %M0", "XORR %M0", "OR(R %M1"],
        ["ST %Q0.0", "ST %M0", "STN %M1", "S %Q0.1", "R %Q0.1"],
        ["%I0.0", "%I0.1", "%I0.2", "%M0", "%M1", "%Q0.1", "%S13"],
    ),
    "gutta": (
        ["LD", "LDN", "A", "AN", "O", "ON"],
        ["ALD", "OLD", "LPS", "LRD", "LPP", "NOT", "P M0.1", "N M0.2"],
        ["= Q0.0", "= M0.0", "S Q0.1, 2", "R Q0.1, 1"],
        ["I0.0", "I0.1", "I0.2", "M0.0", "M0.1", "Q0.1", "SM0.1"],
    ),
}
INPUTS = {"s7-200": "I0.", "gutta": "I0.", "fx": "X", "neza": "%I0."}
COUNT = 3


@st.composite
def lists(draw: st.DrawFn, name: str, *, headings: bool = False) -> str:
    """Draw any lines in any order."""
    contacts, stack, others, bits = MENU[name]
    contact = st.tuples(st.sampled_from(contacts), st.sampled_from(bits)).map(" ".join)
    row = contact | contact | st.sampled_from(stack) | st.sampled_from(others)
    if headings:
        row |= st.just("RUNG 1" if name == "neza" else "Network 1")
    return "\n".join(draw(st.lists(row, min_size=1, max_size=16)))


def inputs(name: str, bits: list[int]) -> dict[str, int]:
    """Name the bits of one scan."""
    return {f"{INPUTS[name]}{number}": bit & 1 for number, bit in enumerate(bits)}


SCANS = st.lists(st.lists(st.integers(0, 1), min_size=COUNT, max_size=COUNT), min_size=1, max_size=4)
"""Up to four scans of three bits each."""
