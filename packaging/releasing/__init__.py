"""The parts of packaging/release: each knows one thing, and builds and commands alone run other programs."""


class Refusal(Exception):
    """Why there is no release: one sentence that says what to do."""
