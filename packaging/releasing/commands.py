"""Other programs, run in the project's folder."""

import pathlib
import shlex
import subprocess
import sys

from . import Refusal

HOME = pathlib.Path(__file__).resolve().parents[2]


def run(*command, cwd=HOME, **more):
    """What a command prints; a failure is a refusal with its last lines."""
    try:
        done = subprocess.run(command, cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **more)
    except FileNotFoundError:
        raise Refusal(f"{command[0]} is not there: install it") from None
    if done.returncode:
        said = "\n".join(done.stdout.strip().splitlines()[-40:])
        raise Refusal(f"'{shlex.join(command)}' failed:\n{said}")
    return done.stdout.strip()


def git(*arguments, cwd=HOME):
    return run("git", *arguments, cwd=cwd)


def asked(*arguments, **more):
    """As git, for questions whose answer may be nothing."""
    return subprocess.run(("git", *arguments), cwd=HOME, capture_output=True, text=True, **more).stdout.strip()


def say(text):
    print(f"packaging/release: {text}", file=sys.stderr, flush=True)
