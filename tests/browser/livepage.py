"""A live bench in a page of its own: the kernel's part is played by a little server, with the very same messages."""

from __future__ import annotations

import json
import threading
from contextlib import contextmanager, suppress
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import TYPE_CHECKING, Any

from plcteach.figure.page import script, styles
from plcteach.machine.live import Live
from plcteach.widgets.live import Session

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.program import Program

PAGE = """<!doctype html><html lang="en"><meta charset="utf-8"><title>live</title>
<style>body {{ margin: 0; padding: 1rem; }} {styles}</style><main id="bench"></main>
<script type="module">
{script}
window.answers = [];
const send = async (message) => {{
  const asked = performance.now();
  const answer = await (await fetch("/ask", {{ method: "POST", body: JSON.stringify(message) }})).json();
  handle.take(answer);
  window.answers.push([asked, performance.now(), answer.scans ?? 0]);
}};
const handle = mountLive(document.getElementById("bench"), {{ cast: {cast}, lang: "{lang}", send }});
</script></html>"""


@contextmanager
def served(program: Program, plant: Any = None, lang: str = "en") -> Iterator[tuple[str, Session]]:
    """Serve a live bench; gives its address and the session behind it."""
    session = Session(Live(program, plant))
    cast = json.dumps(session.watch.cast(), ensure_ascii=False).replace("<", "\\u003c")
    page = PAGE.format(
        styles=styles("player.css", "bench.css", "live.css"), script=script("live.js"), cast=cast, lang=lang
    )

    in_turn = threading.Lock()  # a kernel answers one message after the other

    class Handler(BaseHTTPRequestHandler):
        def log_message(self, *words: object) -> None:
            del words

        def answer(self, kind: str, body: str) -> None:
            self.send_response(200)
            self.send_header("Content-Type", f"{kind}; charset=utf-8")
            self.end_headers()
            with suppress(BrokenPipeError):  # the page has gone
                self.wfile.write(body.encode())

        def do_GET(self) -> None:
            self.answer("text/html", page)

        def do_POST(self) -> None:
            asked = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            with in_turn:
                said = json.dumps(session.answer(asked))
            self.answer("application/json", said)

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/", session
    finally:
        server.shutdown()
        server.server_close()
        thread.join()
