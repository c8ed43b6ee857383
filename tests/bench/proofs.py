"""How long a verdict takes: the exercises' own samples, more and more inputs beside another prover, and what makes a proof dear.

Another prover of ladder programs, pyrung (its `always`, PyPI, MIT), is asked the same question in the same process where it is
installed: whether two conditions over the same inputs are ever different.
"""

from __future__ import annotations

import sys
import time
from importlib import import_module
from statistics import median
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

ENOUGH_S = 20.0


def once(work: Callable[[], Any]) -> tuple[float, Any]:
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


def samples(show: Callable[..., None]) -> None:
    """Judge every sample of every exercise, each for the first time."""
    from plcteach.check.judge import judge
    from plcteach.check.same import forget
    from plcteach.exercises import exercise, ids

    for name in ids():
        judge(name, exercise(name).start)  # the reference is read once for a class as well
    took: list[tuple[float, str, str]] = []
    for name in ids():
        one = exercise(name)
        for text in (*one.right, *(sample.program for sample in one.wrong)):
            forget()
            seconds, judged = once(lambda one=one, text=text: judge(one, text))
            took.append((seconds, name, judged.verdict.status))
    times = sorted(seconds for seconds, _, _ in took)
    worst = max(took)
    show(
        f"{len(took)} samples of {len(ids())} exercises, each judged for the first time",
        ("median (the issue asks for 10 ms)", f"{median(times) * 1e3:.1f} ms"),
        ("95 % (150 ms)", f"{times[int(len(times) * 0.95)] * 1e3:.1f} ms"),
        (f"worst (3 s): {worst[1]}, {worst[2]}", f"{worst[0] * 1e3:.0f} ms"),
        ("all together", f"{sum(times):.1f} s"),
        ("undecided", f"{sum(status == 'unknown' for _, _, status in took)}"),
    )


def beside(show: Callable[..., None]) -> None:
    """Compare two ways of writing a condition over more and more inputs, here and there."""
    from plcteach.check.same import compare, forget
    from plcteach.stl import read

    patient = True
    for inputs in (8, 12, 16, 20, 40, 60):
        names = [f"I{bit // 8}.{bit % 8}" for bit in range(inputs)]
        pairs = list(zip(names[::2], names[1::2], strict=True))
        one = "\n".join([*(f"LD {a}\nAN {b}" + ("\nOLD" if at else "") for at, (a, b) in enumerate(pairs)), "= Q0.0"])
        other = "\n".join(
            [*(f"LDN {b}\nA {a}" + ("\nOLD" if at else "") for at, (a, b) in enumerate(pairs[::-1])), "= Q0.0"]
        )
        wrong = other.replace("LDN", "LD", 1)
        rows = []
        for what, text in (("equal", other), ("different", wrong)):
            reference, student = read(one, "s7-200"), read(text, "s7-200")
            forget()
            ours, verdict = once(lambda r=reference, s=student: compare(r, s))
            rows.append((f"{what}: plcteach, {verdict.status} by {verdict.proof}", f"{ours * 1e3:.2f} ms"))
            if not patient:
                rows.append((f"{what}: pyrung", f"not asked: it took more than {ENOUGH_S} s for fewer inputs"))
                continue
            theirs = asked_of_pyrung(pairs, turned=what == "different")
            if theirs is None:
                continue
            patient &= theirs[0] < ENOUGH_S
            rows.append((f"{what}: pyrung, {theirs[1]}", f"{theirs[0] * 1e3:.2f} ms"))
            if theirs[1] in {"Proven", "Counterexample"}:
                rows.append((f"{what}: pyrung / plcteach", f"{theirs[0] / ours:.1f} times"))
        show(f"{inputs} inputs: are two conditions the same?", *rows)


def asked_of_pyrung(pairs: list[tuple[str, str]], *, turned: bool) -> tuple[float, str] | None:
    """Give the seconds and the answer of pyrung to the same question; None where it is not installed."""
    try:
        pyrung: Any = import_module("pyrung")
        prove: Any = import_module("pyrung.core.analysis.prove")
    except ImportError:
        return None
    bits = {name: pyrung.Bool(name.replace(".", "_"), external=True) for pair in pairs for name in pair}
    one, other = pyrung.Bool("One"), pyrung.Bool("Other")
    mine = [pyrung.And(bits[a], ~bits[b]) for a, b in pairs]
    theirs = [pyrung.And(~bits[b], bits[a]) for a, b in pairs[::-1]]
    if turned:
        theirs[0] = pyrung.And(bits[pairs[-1][1]], bits[pairs[-1][0]])
    with pyrung.Program() as logic:
        with pyrung.Rung(pyrung.Or(*mine)):
            pyrung.out(one)
        with pyrung.Rung(pyrung.Or(*theirs)):
            pyrung.out(other)
    same = pyrung.Or(pyrung.And(one, other), pyrung.And(~one, ~other))
    seconds, answer = once(lambda: prove.always(logic, same))
    return seconds, type(answer).__name__


def dear(show: Callable[..., None]) -> None:
    """Show what a proof costs as presets, states and inputs grow."""
    from plcteach.check.same import compare, forget
    from plcteach.stl import read

    def verdict(one: str, other: str) -> str:
        forget()
        reference, student = read(one, "s7-200"), read(other, "s7-200")
        seconds, found = once(lambda: compare(reference, student))
        return f"{seconds * 1e3:8.1f} ms  {found.status} by {found.proof}, {found.explored} states"

    timer = "LD I0.0\nTON T{t}, {n}\nLD T{t}\n= Q0.0"
    show(
        "cost against the preset: a timer renamed, and one tick off",
        *(
            (f"preset {n}, renamed", verdict(timer.format(t=37, n=n), timer.format(t=38, n=n)))
            for n in (5, 50, 500, 5000, 32767)
        ),
        *(
            (f"preset {n}, one less", verdict(timer.format(t=37, n=n), timer.format(t=38, n=n - 1)))
            for n in (5, 50, 500, 5000)
        ),
    )
    ring = (
        "LD I0.0\nEU\n= M9.{k}\nLD M9.{k}\nAN M{a}.{k}\nLDN M9.{k}\nA M{a}.{k}\nOLD\n= M{a}.{k}\nLD M{a}.{k}\n= Q0.{k}"
    )
    own = ring.replace("I0.0", "I0.{k}")
    for title, text in (("one push-button", ring), ("a push-button each", own)):
        show(
            f"cost against states: toggles, {title}",
            *(
                (
                    f"{n} toggles",
                    verdict(
                        "\n".join(text.format(k=k, a=0) for k in range(n)),
                        "\n".join(text.format(k=k, a=5) for k in range(n)),
                    ),
                )
                for n in (1, 2, 4, 6, 8)
            ),
        )
    seal = "LD I{i}.0\nO Q{i}.0\nAN I{i}.1\nA I{i}.2\n= Q{i}.0"
    late = "LD I{i}.0\nO Q{i}.0\nA I{i}.2\nAN I{i}.1\n= Q{i}.0"
    show(
        "cost against inputs: seal-ins of three inputs each",
        *(
            (
                f"{3 * n} inputs",
                verdict("\n".join(seal.format(i=i) for i in range(n)), "\n".join(late.format(i=i) for i in range(n))),
            )
            for n in (1, 2, 3, 4, 6, 8)
        ),
    )


def main(show: Callable[..., None]) -> None:
    """Show all of it."""
    sys.setrecursionlimit(10_000)
    samples(show)
    beside(show)
    dear(show)
