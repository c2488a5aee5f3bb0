"""The parts of packaging/release: each knows one kind of file, and none runs anything but git."""


class Refusal(Exception):
    """Why there is no release: one sentence that says what to do."""
