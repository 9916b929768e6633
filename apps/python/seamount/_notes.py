"""What the library says although the work goes on: cells that were filled, a strength that had to be limited."""

import logging

logger = logging.getLogger("seamount")
"""Notes come here as warnings; without handlers of your own they stand on the standard error."""


def say(notes):
    for note in notes:
        logger.warning("%s", note)
