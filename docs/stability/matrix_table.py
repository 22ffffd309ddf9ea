"""The table of the stability matrix, read and asked."""

import csv
import statistics

COLUMNS = {  # what the columns of each chapter stand under in the figures
    3: "3. MLCP", 4: "4. Gauss-Seidel", 5: "5. Lemke", 6: "6. Impulses", 7: "7. Baumgarte", 8: "8. Warm starting",
    9: "9. Active sets", 10: "10. Skipping", 11: "11. Rotation", 12: "12. Manifolds", 13: "13. Friction",
    14: "14. Joints", 15: "15. Trees", 16: "16. Soft constraints", 19: "19. The engine", 25: "25. Space",
    26: "26. Four ways"}


class Table:
    def __init__(self, path):
        self.cells, self.values, self.chapters, self.whys, self.runs = {}, {}, {}, {}, 0
        with open(path, encoding="utf-8") as file:
            for row in csv.DictReader(file):
                stress, level, method = row["stress"], int(row["level"]), row["method"]
                self.values.setdefault(stress, {})[level] = row["value"]
                self.chapters[method] = int(row["chapter"])
                self.runs += int(row["seeds"])
                if row["score"]:
                    self.cells[stress, level, method] = (float(row["score"]), int(row["lowest"]))
                    self.whys[stress, level, method] = row["why"]
        self.stresses = list(self.values)
        order = list(self.chapters)
        self.methods = sorted(order, key=lambda method: (self.chapters[method], order.index(method)))

    def cell(self, stress, level, method):
        """(mean as a share, minimum), or None."""
        if stress not in self.values:
            raise SystemExit(f"there is no stress '{stress}' in the table")
        if method not in self.chapters:
            raise SystemExit(f"there is no method '{method}' in the table")
        return self.cells.get((stress, level, method))

    def row(self, stress, method):
        """(mean of the levels, minimum of them), or None."""
        found = [self.cell(stress, level, method) for level in sorted(self.values[stress])]
        found = [cell for cell in found if cell]
        if not found:
            return None
        return statistics.mean(score for score, _ in found), min(lowest for _, lowest in found)

    def total(self, method):
        """(mean of all its stresses, number of cells, cells that ever score 0, cells with 3 throughout)."""
        rows = [self.row(stress, method) for stress in self.stresses]
        cells = [cell for (_, _, name), cell in self.cells.items() if name == method]
        return (statistics.mean(row[0] for row in rows if row), len(cells),
                sum(lowest == 0 for _, lowest in cells), sum(lowest == 3 for _, lowest in cells))
