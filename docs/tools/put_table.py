"""Measured tables: the rows that a benchmark wrote, and the places of tables in a text."""

import csv


def benchmark_rows(file):
    """The rows of Google Benchmark's CSV, whose heading comes after a few lines about the machine."""
    try:
        with open(file, newline="", encoding="utf-8") as stream:
            lines = list(stream)
    except OSError as fault:
        raise SystemExit(f"{file} can't be read: {fault.strerror}") from None
    first = next((i for i, line in enumerate(lines) if line.startswith("name,")), None)
    if first is None:
        raise SystemExit(f"{file} is no CSV of Google Benchmark: no line begins with name,")
    return list(csv.DictReader(lines[first:]))


def above(text, caption, table):
    """The text with the lines of this table in place of those of the table above the paragraph that begins with its caption."""
    lines = text.split("\n")
    at = next((i for i, line in enumerate(lines) if line.startswith(caption)), None)
    if at is None:
        raise SystemExit(f"no paragraph begins with {caption}")
    end = at - 1
    while end >= 0 and lines[end] == "":
        end -= 1
    begin = end
    while begin >= 0 and lines[begin].startswith("|"):
        begin -= 1
    if begin == end:
        raise SystemExit(f"there is no table above {caption}")
    return "\n".join(lines[:begin + 1] + table + lines[end + 1:])


def between(text, mark, table):
    """The text with the lines of this table as all that is between its mark and the next `<!-- /table -->`."""
    lines = text.split("\n")
    begin = [i for i, line in enumerate(lines) if line == mark]
    if len(begin) != 1:
        raise SystemExit(f"{mark} stands {len(begin)} times in the text; it must stand once")
    end = next((i for i in range(begin[0] + 1, len(lines)) if lines[i].startswith(("<!-- /table -->", "<!-- table:"))), None)
    if end is None or lines[end] != "<!-- /table -->":
        raise SystemExit(f"{mark} has no end <!-- /table -->")
    return "\n".join(lines[:begin[0] + 1] + ["", *table, ""] + lines[end:])


def put(text, place, table):
    """A place is a mark, `<!-- table: FILE NAME -->`, or the beginning of the caption below the table."""
    return (between if place.startswith("<!-- table:") else above)(text, place, table)


def put_all(page, tables):
    """place → lines, into the file `page`."""
    text = page.read_text(encoding="utf-8")
    for place, table in tables.items():
        text = put(text, place, table)
    page.write_text(text, encoding="utf-8")


def stale(page, tables):
    """The places in the file `page` where another table stands."""
    text = page.read_text(encoding="utf-8")
    return [place for place, table in tables.items() if put(text, place, table) != text]
