"""Reads the tables in this folder with the types of the codebook, by pandas.

    from tables import read_tables
    tables = read_tables(".")
    tables["gaze"].groupby(["condition", "object"])["dwell"].mean()
"""
import json
import pathlib

import pandas


def read_tables(folder="."):
    folder = pathlib.Path(folder)
    book = json.loads((folder / "codebook.json").read_text(encoding="utf-8"))
    return {file.removesuffix(".csv"): _read(folder / file, told["columns"])
            for file, told in book.items()}


def _read(file, columns):
    # An id such as 001 is a text, and a missing value is an empty cell, not the word "none" or "NA".
    table = pandas.read_csv(file, dtype=str, keep_default_na=False, na_values=[""])
    # An apostrophe says to spreadsheets that a text with = + - @, wide ones too, is no formula.
    formula = r"(?s)(^|[;\t\r\n])'(?='*[ \v\f\u00a0\u3000]*[=+@\uff1d\uff0b\uff0d\uff20-].)"
    table = table.replace(formula, r"\1", regex=True)
    for name, column in columns.items():
        if column["type"] == "whole number":
            table[name] = pandas.to_numeric(table[name]).astype("Int64")
        elif column["type"] == "number":
            table[name] = pandas.to_numeric(table[name]).astype("float64")
        elif column["type"] == "category":
            table[name] = pandas.Categorical(table[name], categories=list(column["levels"]))
        elif column["type"] == "date and time":
            table[name] = pandas.to_datetime(table[name], utc=True, format="ISO8601")
    return table
