# SPDX-License-Identifier: Apache-2.0
"""Orientations as other libraries write them: rotation matrices, homogeneous matrices and SciPy's rotations.

A quaternion q of a rotation matrix follows from the symmetric matrix 4 q q^T, whose entries are sums of entries of the
rotation. Its row with the largest diagonal entry is the one with the least cancellation (Shepperd 1978).
"""

from __future__ import annotations

import math
from typing import Any

from .records import numpy

# The library accepts quaternions whose length is off 1 by as much.
_TOLERANCE = 1e-3
_LAST_ROW = (0.0, 0.0, 0.0, 1.0)


def quaternions(name: str, values: Any) -> Any:
    """Quaternions, scalar first, of a 3 x 3 matrix, of (N, 3, 3) of them, or of a rotation of SciPy.

    Anything else is returned as it is.
    """
    if hasattr(values, "as_quat"):
        return _scalar_first(values.as_quat())
    if getattr(values, "ndim", 0) == 3 and values.shape[1:] == (3, 3):
        return _quaternions_of(name, _floats(name, values))
    rows = _rows(values, 3)
    return values if rows is None else _quaternion_of(name, rows)


def pose_rows(name: str, values: Any) -> Any:
    """Rows of seven numbers of one 4 x 4 matrix or of (N, 4, 4) of them; anything else is returned as it is."""
    shape = getattr(values, "shape", None)
    if shape is not None and len(shape) == 3 and tuple(shape[1:]) == (4, 4):
        return _pose_rows_of(name, _floats(name, values))
    if shape is not None and len(shape) != 2:
        return values
    rows = _rows(values, 4)
    return values if rows is None else _pose_row_of(name, rows)


def _floats(name, values):
    array = numpy().asarray(values)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} holds {array.dtype}; it must hold numbers")
    return array.astype("f8")


def _rows(value, size):
    """A square matrix as rows of floats; None for anything else."""
    if getattr(value, "shape", (size, size)) != (size, size) or not hasattr(value, "__len__") or len(value) != size:
        return None
    rows = [row.tolist() if hasattr(row, "tolist") else row for row in value]
    if not all(isinstance(row, (list, tuple)) and len(row) == size for row in rows):
        return None
    return [[float(number) for number in row] for row in rows]


def _scalar_first(scalar_last):
    """Quaternions of SciPy, which has the scalar last."""
    if getattr(scalar_last, "ndim", 1) == 2:
        return numpy().roll(scalar_last, 1, axis=1)
    x, y, z, w = scalar_last
    return [float(w), float(x), float(y), float(z)]


def _products(a, b, c, d, e, f, g, h, i):
    """4 q q^T of the rotation [[a, b, c], [d, e, f], [g, h, i]], for numbers and for columns of them."""
    return ((1 + a + e + i, h - f, c - g, d - b),
            (h - f, 1 + a - e - i, b + d, c + g),
            (c - g, b + d, 1 - a + e - i, f + h),
            (d - b, c + g, f + h, 1 - a - e + i))


def _quaternion_of(name, rows):
    _expect_rotation(name, *_errors(*(number for row in rows for number in row)))
    products = _products(*(number for row in rows for number in row))
    w, x, y, z = products[max(range(4), key=lambda k: products[k][k])]
    length = math.sqrt(w * w + x * x + y * y + z * z)
    return [w / length, x / length, y / length, z / length]


def _quaternions_of(name, matrices):
    np = numpy()
    entries = [matrices[:, row, column] for row in range(3) for column in range(3)]
    if len(matrices):
        off, volume = _errors(*entries)
        _expect_rotation(name, np.max(off), np.min(volume))
    products = np.array(_products(*entries))
    largest = np.argmax(products[range(4), range(4)], axis=0)
    w, x, y, z = products[largest, :, np.arange(len(matrices))].T
    length = np.sqrt(w * w + x * x + y * y + z * z)
    return np.stack([w / length, x / length, y / length, z / length], axis=1)


def _errors(a, b, c, d, e, f, g, h, i):
    """How far the rows are from unit length and right angles, and the determinant."""
    off = (abs(a * a + b * b + c * c - 1) + abs(d * d + e * e + f * f - 1) + abs(g * g + h * h + i * i - 1)
           + abs(a * d + b * e + c * f) + abs(d * g + e * h + f * i) + abs(g * a + h * b + i * c))
    return off, a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def _expect_rotation(name, off, volume):
    if not off <= 6 * _TOLERANCE:
        raise ValueError(f"{name} is no rotation: its rows are not of length 1 and at right angles. Scale shapes, not "
                         "poses")
    if volume < 0:
        raise ValueError(f"{name} is no rotation: it mirrors. Mirror shapes, not poses")


def _pose_row_of(name, rows):
    if any(abs(found - expected) > 1e-9 for found, expected in zip(rows[3], _LAST_ROW)):
        raise ValueError(f"{name} has the last row {tuple(rows[3])}; it must be {_LAST_ROW}. The translation is the "
                         "last column")
    return [row[3] for row in rows[:3]] + _quaternion_of(name, [row[:3] for row in rows[:3]])


def _pose_rows_of(name, matrices):
    np = numpy()
    wrong = np.abs(matrices[:, 3] - _LAST_ROW).max(axis=1, initial=0) > 1e-9
    if wrong.any():
        first = int(np.argmax(wrong))
        raise ValueError(f"{name} has the last row {tuple(matrices[first, 3].tolist())} in matrix {first}; it must be "
                         f"{_LAST_ROW}. The translation is the last column")
    return np.concatenate([matrices[:, :3, 3], _quaternions_of(name, matrices[:, :3, :3])], axis=1)
