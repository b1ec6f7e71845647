# SPDX-License-Identifier: MIT
"""All rows of the table."""

from row import Row

from rows import (
    cam_shape,
    free_front,
    free_rise,
    jerk_limit,
    mean_square,
    one_variable,
    roller_front,
)


def all_rows() -> list[Row]:
    rooms = (free_front, jerk_limit, free_rise, cam_shape, one_variable, roller_front, mean_square)
    return [row for room in rooms for row in room.rows()]
