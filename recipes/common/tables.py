"""Tables of sweeps (collect.py): columns of numbers, NaN where a cell is empty."""

import csv

import numpy as np


def read_rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def numbers(rows, column):
    return np.array([float(row[column]) if row.get(column) else np.nan for row in rows])
