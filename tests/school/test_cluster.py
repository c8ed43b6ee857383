"""`plcteach grade --cluster` on a real dask.distributed cluster: the same bytes as without it."""

from __future__ import annotations

from pathlib import Path

import pytest

distributed = pytest.importorskip("distributed", reason="distributed is not installed here (extra `cluster`)")

from plcteach.cli import main  # noqa: E402 (only where there is a cluster)

TEXTS = {
    "alice": "LD I0.0\nA I0.1\nLD I0.2\nAN I0.3\nOLD\n= Q0.0\n",
    "bob": "LD I0.0\nA I0.1\nO I0.2\nAN I0.3\n= Q0.0\n",
    "carol": "OLD\n",
    "李雷": "LDN I0.3\nA I0.2\nLD I0.1\nA I0.0\nOLD\n= Q0.0\n",
}


@pytest.fixture
def folder(tmp_path) -> Path:
    folder = tmp_path / "class"
    folder.mkdir()
    for name, text in TEXTS.items():
        (folder / f"{name}.stl").write_text(text, encoding="utf-8")
    return folder


def everything(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.filterwarnings("ignore::ResourceWarning")
def test_a_cluster_gives_the_same_bytes(folder, tmp_path, capsys) -> None:
    here, there = tmp_path / "here", tmp_path / "there"
    assert main(["grade", str(folder), "--exercise", "s7-two-blocks", "-o", str(here)]) == 0
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        call = ["grade", str(folder), "--exercise", "s7-two-blocks", "-o", str(there)]
        assert main([*call, "--cluster", cluster.scheduler_address]) == 0
    assert everything(here) == everything(there)
    assert capsys.readouterr().err == ""


def test_no_cluster_there_is_a_wrong_call(folder, tmp_path, capsys, monkeypatch) -> None:
    monkeypatch.setattr("plcteach.check.marking.cluster._CONNECT_SECONDS", 1)
    call = ["grade", str(folder), "--exercise", "s7-two-blocks", "-o", str(tmp_path / "out")]
    assert main([*call, "--cluster", "tcp://127.0.0.1:9"]) == 2
    assert "no cluster answers there" in capsys.readouterr().err
