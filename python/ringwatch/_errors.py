"""What goes wrong."""


class InputError(ValueError):
    """What the caller can mend: a file, an argument, an array. One line that names it and says what would be right."""


class NumericalError(ArithmeticError):
    """What the mathematics refuses: an element without volume, a tangent that is not finite. Names element and value."""


InputError.__module__ = NumericalError.__module__ = "ringwatch"
