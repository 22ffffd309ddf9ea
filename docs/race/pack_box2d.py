#!/usr/bin/env python3
"""Packs the npm package box2d3-wasm for the page of the race: one script, which loads from a page opened as a file too.

    docs/race/pack_box2d.py PACKAGE_FOLDER OUTPUT.js

The build named `compat` is taken: the other one has vector instructions, but needs memory that threads share, and a browser gives
that only to pages whose host sends two headers for it. Its licence is MIT; the text goes with it.
"""
import base64
import json
import pathlib
import sys


def main():
    package, script = map(pathlib.Path, sys.argv[1:3])
    version = json.loads((package / "package.json").read_text(encoding="utf-8"))["version"]
    folder = package / "build/dist/es/compat"
    source = (folder / "Box2D.compat.mjs").read_text(encoding="utf-8")
    end = "export default Box2D;"
    if end not in source:
        raise SystemExit(f"{folder}/Box2D.compat.mjs does not end as it did in 5.2.0: no '{end}'")
    source = source.replace("import.meta.url", "'file:///box2d3-wasm'").replace(end, "")
    code = base64.b64encode((folder / "Box2D.compat.wasm").read_bytes()).decode()
    licence = (package / "LICENSE").read_text(encoding="utf-8").replace("*/", "* /")
    script.parent.mkdir(parents=True, exist_ok=True)
    script.write_text(f"/* box2d3-wasm {version}\n\n{licence}*/\n(function (space) {{\n{source}\n"
                      f"space.rigid_box2d = {{version: '{version}', factory: Box2D, code: '{code}'}};\n}})(globalThis);\n",
                      encoding="utf-8")


if __name__ == "__main__":
    main()
