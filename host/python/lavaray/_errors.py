"""The one exception of this package."""

from __future__ import annotations


class Error(RuntimeError):
    """What everything here raises that fails. str() is a sentence for the user.

    kind: "usage" (options), "input" (a scene, mesh or image), "device", "output" (a file), "memory" or "internal".
    file, line: where, as a path and a number from 1; None where it is about none.
    """

    def __init__(self, message: str, kind: str = "internal", file: str | None = None, line: int | None = None) -> None:
        super().__init__(message)
        self.kind = kind
        self.file = file
        self.line = line
