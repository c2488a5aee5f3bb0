#!/usr/bin/env python3
"""Receives what participants send from their browsers and keeps it in SQLite: see docs/web-data.md."""
import argparse
import contextlib
import csv
import datetime
import errno
import http.server
import json
import os
import pathlib
import re
import sqlite3
import threading

LARGEST = 16 << 20  # bytes of a request; pages send parts of 1 MiB, more if one record alone has more
SESSIONS = "sessions.csv"
MOST_PARTS = 100_000  # of a session
SESSION = re.compile("[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}")
TABLES = """
CREATE TABLE IF NOT EXISTS part (session TEXT NOT NULL, part INTEGER NOT NULL, final INTEGER NOT NULL,
  received TEXT NOT NULL, records TEXT NOT NULL, PRIMARY KEY (session, part));
CREATE TABLE IF NOT EXISTS slot (slot INTEGER PRIMARY KEY, session TEXT UNIQUE, taken TEXT);
"""


class Refused(Exception):
    """A request that is not answered; its arguments are the status of HTTP and a sentence."""


def not_a_number(name):
    raise ValueError(name + " is not JSON")


def now():
    return datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds")


def opened(path, megabytes=None):
    database = sqlite3.connect(path, check_same_thread=False, isolation_level=None)
    database.execute("PRAGMA journal_mode = WAL")
    database.execute("PRAGMA synchronous = FULL")  # a part that is answered outlives a power cut
    if megabytes:
        page = database.execute("PRAGMA page_size").fetchone()[0]
        database.execute(f"PRAGMA max_page_count = {megabytes * (1 << 20) // page}")
    database.executescript(TABLES)
    return database


def store(database, message):
    part, final, records = message.get("part"), message.get("final"), message.get("records")
    if type(part) is not int or not 0 <= part < MOST_PARTS or type(final) is not bool or type(records) is not list:
        raise Refused(400, "part, final or records are missing or not what they should be")
    text = json.dumps(records)
    row = (message["session"], part, final, now(), text)
    if database.execute("INSERT OR IGNORE INTO part VALUES (?, ?, ?, ?, ?)", row).rowcount == 0:
        there = database.execute("SELECT final, records FROM part WHERE session = ? AND part = ?", row[:2]).fetchone()
        if there != (final, text):
            raise Refused(409, "another part of this number is there already")
    return {"received": len(records)}


def take(database, message):
    mine = "SELECT slot FROM slot WHERE session = ?"
    found = database.execute(mine, (message["session"],)).fetchone()
    if found is None:
        free = "(SELECT min(slot) FROM slot WHERE session IS NULL)"
        database.execute(f"UPDATE slot SET session = ?, taken = ? WHERE slot = {free}", (message["session"], now()))
        found = database.execute(mine, (message["session"],)).fetchone()
    if found is None:
        raise Refused(410, "all places of the study are taken")
    return {"slot": found[0]}


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    timeout = 60  # seconds that a silent connection is kept
    answers = {"data": store, "slot": take}

    def do_OPTIONS(self):
        allowed = self.headers.get("Origin") in self.server.origins
        self.answer(204 if allowed else 403, None)

    def do_POST(self):
        try:
            self.answer(200, self.handled())
        except Refused as refused:
            self.answer(refused.args[0], {"error": refused.args[1]})
        except (ValueError, RecursionError):
            self.answer(400, {"error": "the request is not JSON"})
        except sqlite3.Error as e:
            self.log_error("%s", e)
            self.answer(507, {"error": "the data cannot be stored"})

    def handled(self):
        length = self.headers.get("Content-Length", "")
        if self.headers.get("Origin") not in self.server.origins:
            raise Refused(403, "this page may not send data here")
        if not length.isdecimal() or int(length) > LARGEST:
            raise Refused(413, f"a request has at most {LARGEST} bytes")
        body = self.rfile.read(int(length))
        if len(body) < int(length):
            raise Refused(400, "the request was cut off")
        message = json.loads(body.decode("utf-8"), parse_constant=not_a_number)
        handle = self.answers.get(self.path.rsplit("/", 1)[-1])
        if handle is None or type(message) is not dict or message.get("study") != self.server.study:
            raise Refused(404, "this study is not here")
        if type(message.get("session")) is not str or not SESSION.fullmatch(message["session"]):
            raise Refused(400, "session is not a UUID")
        with self.server.lock:
            return handle(self.server.database, message)

    def answer(self, status, content):
        body = b"" if content is None else json.dumps(content).encode()
        self.close_connection = self.close_connection or status >= 400  # what was not read must not be a next request
        self.send_response(status)
        self.send_header("Vary", "Origin")
        if self.headers.get("Origin") in self.server.origins:
            self.send_header("Access-Control-Allow-Origin", self.headers["Origin"])
            self.send_header("Access-Control-Allow-Headers", "Content-Type")
            self.send_header("Access-Control-Max-Age", "86400")
        if self.close_connection:
            self.send_header("Connection", "close")
        if status != 204:
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_error(self, format, *args):
        """Leaves connections that were silent too long out of the log: participants read while their page waits."""
        if not format.startswith("Request timed out"):
            super().log_error(format, *args)

    def log_request(self, code="-", size="-"):
        """Leaves requests that were answered out of the log."""

    def address_string(self):
        return "a participant"  # whose address is not written down


class Receiver(http.server.ThreadingHTTPServer):
    daemon_threads = True
    request_queue_size = 1024

    def __init__(self, options):
        super().__init__((options.host, options.port), Handler)
        self.origins, self.study, self.lock = options.origin, options.study, threading.Lock()
        self.database = opened(options.database, options.megabytes)
        self.database.execute("DELETE FROM slot WHERE session IS NULL AND slot > ?", (options.slots,))
        self.database.execute("BEGIN")
        for slot in range(1, options.slots + 1):
            self.database.execute("INSERT OR IGNORE INTO slot (slot) VALUES (?)", (slot,))
        self.database.execute("COMMIT")

    def handle_error(self, request, client_address):
        """Leaves connections that participants cut out of the log."""


def written_before(database, folder):
    """Tells what in the folder is not of an earlier --write of this database; empty if all is, or nothing is there."""
    known = {session for (session,) in database.execute("SELECT session FROM part")}
    for path in sorted(folder.iterdir()):
        own = path.name == SESSIONS or path.suffix in (".jsonl", ".part") and path.stem.split(".")[0] in known
        if not own and path.name != SESSIONS + ".part" or path.is_symlink() or not path.is_file():
            return path.name
    return ""


@contextlib.contextmanager
def replacing(path, **how):
    """Opens a file that takes the place of an earlier one as a whole, once it is written."""
    part = path.with_name(path.name + ".part")
    with open(part, "w", encoding="utf-8", **how) as file:
        yield file
    os.replace(part, path)


def write(database, folder):
    folder.mkdir(parents=True, exist_ok=True)
    slots = dict(database.execute("SELECT session, slot FROM slot WHERE session IS NOT NULL"))
    parts = {}
    for session, part, final in database.execute("SELECT session, part, final FROM part ORDER BY session, part"):
        parts.setdefault(session, []).append((part, final))
    with replacing(folder / SESSIONS, newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["session", "slot", "parts", "missing", "final"])
        for session in sorted(parts.keys() | slots.keys()):
            there = dict(parts.get(session, []))
            missing = [part for part in range(max(there, default=-1)) if part not in there]
            final = "yes" if any(there.values()) else "no"
            table.writerow([session, slots.get(session, ""), len(there), " ".join(map(str, missing)), final])
    for session in parts:
        # A text of JavaScript may end within a character; backslashreplace spells the half as JSON does.
        path = folder / (session + ".jsonl")
        with replacing(path, errors="backslashreplace", newline="\n") as file:
            query = "SELECT records FROM part WHERE session = ? ORDER BY part"
            for (records,) in database.execute(query, (session,)):
                file.writelines(json.dumps(record, ensure_ascii=False) + "\n" for record in json.loads(records))


def give_back(database, hours):
    before = datetime.datetime.now(datetime.timezone.utc) - datetime.timedelta(hours=hours)
    alive = "SELECT session FROM part WHERE final OR received > :before"
    left = f"session IS NOT NULL AND taken <= :before AND session NOT IN ({alive})"
    limit = {"before": before.isoformat(timespec="seconds")}
    for slot, session in database.execute(f"SELECT slot, session FROM slot WHERE {left}", limit).fetchall():
        database.execute("UPDATE slot SET session = NULL, taken = NULL WHERE slot = ? AND session = ?", (slot, session))
        print(f"{slot} is free again; it was that of {session}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("database")
    parser.add_argument("--study", help="the study's name, as in study-web.json")
    parser.add_argument("--origin", action="append", default=[], help="of the page, such as https://lab.example.org")
    parser.add_argument("--slots", type=int, default=0, help="number of places in the study's plan")
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=8010, help="to listen at (default: %(default)s)")
    parser.add_argument("--megabytes", type=int, default=10_000, help="that the database may grow to")
    parser.add_argument("--write", type=pathlib.Path, metavar="DIR", help="write one file a session instead, or update those written before")
    parser.add_argument("--give-back", type=float, metavar="HOURS", help="free places of sessions silent so long")
    options = parser.parse_args()
    if options.write or options.give_back is not None:
        if not pathlib.Path(options.database).is_file():
            parser.error(options.database + ": no such file")
        database = opened(options.database)
        if options.give_back is not None:
            give_back(database, options.give_back)
        if options.write:
            other = options.write.is_dir() and written_before(database, options.write)
            if other:
                parser.error(f"{options.write}: has {other}, which no --write of this database made; name a new folder")
            write(database, options.write)
        return
    if not options.study or not options.origin:
        parser.error("--study and --origin are needed to receive")
    try:
        receiver = Receiver(options)
    except OSError as e:
        if e.errno != errno.EADDRINUSE:
            raise
        where = f"{options.host}:{options.port}"
        parser.error(f"--port {options.port}: another program listens at {where} already; name another port")
    try:
        print(f"receiving at http://{options.host}:{receiver.server_port}", flush=True)
        receiver.serve_forever()
    except KeyboardInterrupt:
        pass
    finally:
        receiver.server_close()
        receiver.database.close()


if __name__ == "__main__":
    main()
