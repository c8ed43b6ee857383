"""GUTTA's rules one by one: each row says a sentence of the notes and shows it in scans; then what is refused, and with which code."""

from __future__ import annotations

import pytest

from .rules import Rule, check, said

AB = "I0.0 0011; I0.1 0101"

STACKS = [
    *(
        Rule(f"{word} b is LD b and a join", f"LD I0.0 / {word} I0.1 / = Q0.0 / LD I0.0 / {load} I0.1 / {join} / = Q0.1", AB, f"Q0.0 {bits}; Q0.1 {bits}")
        for word, load, join, bits in (
            ("A", "LD", "ALD", "0001"), ("AN", "LDN", "ALD", "0010"), ("O", "LD", "OLD", "0111"), ("ON", "LDN", "OLD", "1011"),
        )
    ),
    Rule("fused or not, the same behind a block", "LD I0.0 / LD I0.1 / O I0.2 / A I0.3 / ALD / = Q0.0 / LD I0.0 / LD I0.1 / LD I0.2 / OLD / LD I0.3 / ALD / ALD / = Q0.1", AB + "; I0.2 1010; I0.3 1110", "Q0.0 0010; Q0.1 0010"),
    Rule("an output leaves the flow", "LD I0.0 / = Q0.0 / A I0.1 / = Q0.1", AB, "Q0.0 0011; Q0.1 0001"),
    Rule("LPS saves the flow beside the data stack; LRD and LPP overwrite the top with it", "LD I0.0 / LPS / A I0.1 / = Q0.0 / LRD / AN I0.1 / = Q0.1 / LPP / = Q0.2", AB, "Q0.0 0001; Q0.1 0010; Q0.2 0011"),
    Rule("the auxiliary stack is not moved by a join", "LD I0.0 / LPS / LD I0.1 / O I0.2 / ALD / = Q0.0 / LPP / = Q0.1", AB + "; I0.2 1010", "Q0.0 0011; Q0.1 0011"),
    Rule("NOT turns the whole flow on its left", "LD I0.0 / O I0.1 / NOT / = Q0.0", AB, "Q0.0 1000"),
    Rule("P is on at a rise, also in the first scan, and keeps the flow in m", "LD I0.0 / P M0.0 / = Q0.0", "I0.0 110010", "Q0.0 100010; M0.0 110010"),
    Rule("N is on at a fall, never in the first scan", "LD I0.0 / N M0.0 / = Q0.0", "I0.0 011010", "Q0.0 000101; M0.0 011010"),
    Rule("m may hold a 1 beforehand", "LD I0.0 / P M0.0 / = Q0.0", "I0.0 11; M0.0 1", "Q0.0 00"),
    Rule("two P with one m: the second never fires", "LD I0.0 / P M0.0 / = Q0.0 / LD I0.0 / P M0.0 / = Q0.1", "I0.0 0101", "Q0.0 0101; Q0.1 0000"),
    Rule("a NOT beside a contact, joined by ALD: the flow is lost", "LD I0.0 / LDN I0.0 / O I0.1 / ALD / = Q0.0", AB, "Q0.0 0001"),
    Rule("a NOT beside a contact, the stem loaded twice: /a + a b", "LD I0.0 / NOT / LD I0.0 / A I0.1 / OLD / = Q0.0", AB, "Q0.0 1101"),
    Rule("a NOT beside a contact, the stem saved: /a + a b", "LD I0.0 / LPS / NOT / LD SM0.0 / LPP / A I0.1 / OLD / = Q0.0", AB, "Q0.0 1101"),
    Rule("S and R latch", "LD I0.0 / S Q0.0, 2 / LD I0.1 / R Q0.1, 1", "I0.0 0100; I0.1 0001", "Q0.0 0111; Q0.1 0110"),
]  # fmt: skip

BLOCKS = [
    Rule("an on-delay", "LD I0.0 / TON T37, 2", "I0.0 11110", "T37 00110; T37.V=0,1,2,3,0", 100),
    Rule("an off-delay", "LD I0.0 / TOF T37, 2", "I0.0 0110000", "T37 0111100", 100),
    Rule("a retentive on-delay", "LD I0.0 / TONR T5, 2", "I0.0 11001", "T5.V=0,1,2,2,2; T5 00111", 100),
    Rule("CTU finds R on top and CU below it", "LD I0.0 / LD I0.1 / CTU C0, 2", "I0.0 010101; I0.1 000001", "C0.V=0,1,1,2,2,0; C0 000110"),
    Rule("CTUD finds R on top, CD below it, CU below that", "LD I0.0 / LD I0.1 / LD I0.2 / CTUD C2, 1", "I0.0 010100; I0.1 000010; I0.2 000001", "C2.V=0,1,1,2,1,0; C2 011110"),
    Rule("a box in two: MOVW and +I, with the same flow", "LD I0.0 / MOVW MW0, MW4 / +I MW2, MW4", "I0.0 01; MW0=30; MW2=12; MW4=1", "MW4=1,42"),
    Rule("where OUT is IN2 the first half spoils it: 2000 and not 1000 + MW4", "LD SM0.0 / MOVW 1000, MW4 / +I MW4, MW4", "MW4=7", "MW4=2000"),
    Rule("an overlap of one byte spoils it too", "LD SM0.0 / MOVW MW0, MW3 / +I MW4, MW3", "MW0=258; MW4=772", "MW3=774"),
    Rule("words are compared as in a contact", "LDW>= MW0, 3 / AW< MW0, 5 / OW= MW0, 9 / = Q0.0", "MW0=2,3,5,9", "Q0.0 0101"),
    Rule("SM0.1 is the first scan, SM0.0 is on", "LD SM0.1 / = Q0.0 / LD SM0.0 / = Q0.1", "I0.0 000", "Q0.0 100; Q0.1 111"),
]  # fmt: skip


@pytest.mark.parametrize("rule", [*STACKS, *BLOCKS], ids=str)
def test_a_rule_of_gutta(rule: Rule) -> None:
    check(rule, "gutta")


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("LD I0.0/ALD/= Q0.0", ("error", "STK001", 2)),
        ("LD I0.0/= Q0.0/LRD/= Q0.1", ("error", "STK003", 3)),
        ("LD I0.0/= Q0.0/LPP/= Q0.1", ("error", "STK003", 3)),
        ("Network 1/LD I0.0/LPS/= Q0.0/Network 2/LPP/= Q0.1", ("error", "STK003", 6)),
        ("Network 1/LD I0.0/= Q0.0/Network 2/A I0.1/= Q0.1", ("error", "STK001", 5)),
        ("LD I0.0/LD I0.1/= Q0.0", ("error", "STK005", 3)),
        ("LD I0.0/LPS/A I0.1/= Q0.0", ("error", "STK005", 4)),
        ("LD I0.0/LD I0.1/LD I0.2/CTUD C0, 3/= Q0.0", ("error", "STK013", 5)),
        ("/".join(["LD I0.0"] * 33 + ["OLD"] * 32 + ["= Q0.0"]), ("error", "STK002", 33)),
        ("LD I0.0" + "/LPS/A I0.1" * 33 + "/= Q0.0" + "/LPP/= Q0.1" * 33, ("error", "STK002", 66)),
        ("LD I0.0/LD I0.1/OLD/= Q0.0", ("info", "STK007", 2)),
        ("LD I0.0/P M0.0/= Q0.0/LD I0.1/N M0.0/= Q0.1", ("warning", "COI002", 5)),
        ("LD I0.0/P M0.0/= Q0.0/LD I0.1/= M0.0", ("warning", "COI002", 2)),
        ("LD SM0.0/ADD_I 1000, MW4, MW4", ("warning", "BOX001", 2)),
        ("LD SM0.0/ADD_I MW0, MW4, MW3", ("warning", "BOX001", 2)),
    ],
)  # fmt: skip
def test_what_gutta_does_not_take(text: str, wanted: tuple[str, str, int]) -> None:
    assert wanted in said(text, "gutta")


@pytest.mark.parametrize(
    "text", ["LD SM0.0/ADD_I MW4, 1000, MW4", "LD SM0.0/ADD_I MW0, MW2, MW4", "LD SM0.0/ADD_I MW4, MW4, MW4"]
)
def test_boxes_that_are_right_as_they_are_split(text: str) -> None:
    assert said(text, "gutta") == []
