#!/usr/bin/env python3
"""The sentences whose numbers can be dragged on the site, as JSON for docs/web/test/sentences.mjs.

    <!-- sentence: spring; h, the time step, from 0.05 to 2.2 by 0.05 s; shows twelve steps in the phase plane -->
    With a step of <span data-slide="h">0.5</span> s the energy is <span data-value="explicit 3">14.6</span> times …

The comment stands right above the paragraph. First the model (chapters/NN_name/sentence.js has it); then each number
that can be dragged: its name in the model, in words, its range and its unit; last, what the small figure shows. In the
paragraph a `data-slide` is such a number, and a `data-value` one that follows: `explicit 3` has three significant
digits, `explicit .3` three decimals, `verdict` is a word. A code host shows the paragraph as it is.
"""
import html
import json
import re

from booktext import SPAN, ROOT, TextError, blocks, markdown_files, run_tool

SENTENCE = re.compile(r"^<!--\s*sentence:(.*)-->\s*$")
SLIDER = re.compile(r"(\w+), (.+), from (-?[\d.]+) to (-?[\d.]+) by ([\d.]+)(?: (\S+))?")


def parse(text, where):
    """A sentence's model, sliders and figure, from what stands behind `sentence:`."""
    model, *parts = [part.strip() for part in text.split(";")]
    if not re.fullmatch(r"\w+", model) or len(parts) < 2 or not parts[-1].startswith("shows "):
        raise TextError(f"{where}: a sentence names its model, its numbers, and last what its figure 'shows …'.")
    sliders = []
    for part in parts[:-1]:
        found = SLIDER.fullmatch(part)
        if not found:
            raise TextError(f"{where}: 'h, the time step, from 0.1 to 2 by 0.1 s' is a number to drag, not '{part}'.")
        name, says, low, high, by, unit = found.groups()
        sliders.append({"name": name, "says": says, "from": float(low), "to": float(high), "by": float(by), "unit": unit or ""})
    return {"model": model, "sliders": sliders, "shows": parts[-1][len("shows "):]}


def number(words):
    """'−1,000' as a number."""
    return float(words.replace("−", "-").replace(",", ""))


def sentence_of(block, paragraph, where):
    """The sentence of a comment block and the paragraph below it, or None."""
    found = SENTENCE.match(" ".join(line.strip() for line in block.lines)) if block.kind == "comment" else None
    if not found:
        return None
    sentence = parse(found.group(1), where)
    if paragraph is None or paragraph.kind != "paragraph" or paragraph.line != block.line + len(block.lines):
        raise TextError(f"{where}: a sentence's comment stands right above its paragraph.")
    spans = [m.groups() for m in SPAN.finditer(paragraph.text)]
    sentence["slides"] = {what: words for kind, what, words in spans if kind == "slide"}
    sentence["values"] = [[what, words] for kind, what, words in spans if kind == "value"]
    named = {slider["name"] for slider in sentence["sliders"]}
    if set(sentence["slides"]) != named:
        raise TextError(f"{where}: the paragraph drags {sorted(sentence['slides'])}, its comment {sorted(named)}.")
    for slider in sentence["sliders"]:
        try:
            slider["value"] = number(sentence["slides"][slider["name"]])
        except ValueError:
            raise TextError(f"{where}: {sentence['slides'][slider['name']]} is no number to drag.") from None
        steps = (slider["value"] - slider["from"]) / slider["by"]
        if not slider["from"] <= slider["value"] <= slider["to"] or abs(steps - round(steps)) > 1e-9:
            raise TextError(f"{where}: {slider['name']} is {slider['value']:g}, which is not in its range, or between its steps.")
    return sentence


def place(sentence):
    """The beginning of the place of a sentence on the site."""
    data = json.dumps({key: sentence[key] for key in ("model", "sliders", "shows")}, ensure_ascii=False)
    return f'<div class="sentence" data-sentence="{html.escape(data)}">'


def sentences_of(root, path):
    name = path.relative_to(root).as_posix()
    parts = blocks(path.read_text(encoding="utf-8"), name)
    found = [sentence_of(block, after, f"{name}:{block.line}") for block, after in zip(parts, parts[1:] + [None])]
    return [{"where": name, "chapter": path.parent.name, **sentence} for sentence in found if sentence]


def main():
    print(json.dumps([sentence for path in markdown_files(ROOT) for sentence in sentences_of(ROOT, path)]))


if __name__ == "__main__":
    run_tool(main)
