# SPDX-License-Identifier: GPL-2.0-or-later
"""The exit status of a comparison of several levels."""

from python_environment import UNAVAILABLE


def status_of(results):
    """Results: True where a level agrees, False where not, None where it was not there. 0: something was compared, and
    all of it agrees; 1: something disagrees; UNAVAILABLE: nothing was compared."""
    if False in results:
        return 1
    if True in results:
        return 0
    print("crosscheck: compared nothing")
    return UNAVAILABLE
