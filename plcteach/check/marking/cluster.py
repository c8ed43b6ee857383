"""The same judging on the machines of a dask.distributed cluster, which is there only where its extra is installed."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from plcteach.check.marking.mark import Mark, mark_of, stopped, version
from plcteach.check.marking.workers import SECONDS
from plcteach.core.errors import PlcTeachError
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from plcteach.core.exercise import Exercise

_CONNECT_SECONDS = 10
_LOST = Text("集群没有给出结果", "the cluster gave no answer")


def marked_there(
    exercise: Exercise, texts: Mapping[str, str], address: str, seconds: float = SECONDS
) -> Iterator[tuple[str, Mark]]:
    """Judge texts on a cluster, and give each mark as soon as it is there; PlcTeachError if there is no such cluster.

    When for `seconds` nothing has come, what is missing says so in its row.
    """
    if find_spec("distributed") is None:
        msg = "dask.distributed is not installed here. Install it with: pip install 'plcteach[cluster]'"
        raise PlcTeachError(msg)
    distributed: Any = import_module("distributed")
    try:
        client = distributed.Client(address, timeout=_CONNECT_SECONDS)
    except (OSError, ValueError, TimeoutError) as trouble:
        msg = f"{address}: no cluster answers there ({type(trouble).__name__})"
        raise PlcTeachError(msg) from None
    with client:
        _same_version(client, address)
        futures = {client.submit(mark_of, exercise, text, key=f"plcteach-{key}"): key for key, text in texts.items()}
        missing = dict.fromkeys(texts)
        while futures:
            try:
                done = distributed.wait(list(futures), timeout=seconds, return_when="FIRST_COMPLETED").done
            except (distributed.TimeoutError, TimeoutError):
                break
            for future in done:
                key = futures.pop(future)
                missing.pop(key)
                yield key, _mark(future)
        client.cancel(list(futures))
        yield from ((key, stopped(_LOST)) for key in missing)


def _same_version(client: Any, address: str) -> None:
    """Refuse a cluster with another plcteach: its marks could be others."""
    try:
        theirs = set(client.run(version).values())
    except Exception as trouble:  # noqa: BLE001 (whatever a machine elsewhere raises)
        msg = f"{address}: plcteach does not run there ({type(trouble).__name__}); install it on the workers"
        raise PlcTeachError(msg) from None
    if theirs != {version()}:
        msg = f"{address}: its workers have {', '.join(sorted(theirs)) or 'no'} plcteach, here is {version()}"
        raise PlcTeachError(msg)


def _mark(future: Any) -> Mark:
    told = future.result() if future.status == "finished" else None
    return told if isinstance(told, Mark) else stopped(_LOST)
