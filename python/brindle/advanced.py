"""Rarely used parts: patterns from phases that others solved, buffers for renderers of your own,
measured fields frame by frame, crossings of two patterns, files of strokes, the table of options."""

from ._animate import FieldSmoothing as FieldSmoothing
from ._animate import PatternFrames as PatternFrames
from ._options import option_rows as option_rows
from ._patterns import has_solver as has_solver
from ._patterns import samples_of as samples_of
from ._patterns import stripes_from_phases as stripes_from_phases
from ._surface import read_strokes as read_strokes
from ._surface import write_strokes as write_strokes

__all__ = ["FieldSmoothing", "PatternFrames", "has_solver", "option_rows", "read_strokes",
           "samples_of", "stripes_from_phases", "write_strokes"]
