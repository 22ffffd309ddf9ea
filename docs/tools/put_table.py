"""Puts a measured table where it stands in a text: above the paragraph that begins with its caption."""


def put(text, caption, table):
    """The text with the lines of this table in place of those of the table above the caption."""
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


def put_all(page, tables):
    """caption → lines, into the file `page`."""
    text = page.read_text(encoding="utf-8")
    for caption, table in tables.items():
        text = put(text, caption, table)
    page.write_text(text, encoding="utf-8")
