"""What can go wrong, with the program's own message.

All are :class:`StickbandError`; those that blame what was passed are ``ValueError`` too.
Ctrl-C during long work raises ``KeyboardInterrupt``, a file that cannot be written
``OSError``, a time limit that ends a search before it has found anything ``TimeoutError``.
"""


class StickbandError(Exception):
    """Base of what this package raises."""


class BadInput(StickbandError, ValueError):
    """A file, an array or a model that is not what it ought to be.

    Attributes
    ----------
    file : str
        File, or ``"array u"``; ``""`` where only the message tells.
    line, column : int
        From 1 on, columns in bytes; 0: the whole file or line is meant.
    expected, found, advice : str
        The parts of the message: what ought to be there, what is, what to do.
    """

    def __init__(self, message: str, file: str = "", line: int = 0, column: int = 0,
                 expected: str = "", found: str = "", advice: str = "") -> None:
        super().__init__(message)
        self.file = file
        self.line = line
        self.column = column
        self.expected = expected
        self.found = found
        self.advice = advice


class WrongUsage(StickbandError, ValueError):
    """Arguments that do not go together, or name nothing: an unknown effect, say."""


class DataCannotAnswer(StickbandError, ValueError):
    """The recording cannot show what was asked for; the message says what would.

    A verdict that is ``undecided`` is an answer and raises nothing.
    """
