"""Tests of table.py: python3 docs/results/test_table.py"""

import math
import pathlib
import tempfile
import unittest

import table

HEAD = "chapter,method,scene,parameters,h,sweeps,work,instructions,time_ratio,error,status"


def made_of(*rows):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "table.csv"
        file.write_text("\n".join((HEAD,) + rows) + "\n")
        return table.Table(file)


def row(method, sweeps, time, error, scene="line", chapter="4", status="iteration limit"):
    return (f"{chapter},{method},{scene},links=4 sweeps={sweeps} unit=row_visit reference=rest,0.1,{sweeps},"
            f"{4 * sweeps},,{time},{error},{status}")


class TableTest(unittest.TestCase):
    def test_a_scene_is_named_with_its_own_parameters_and_not_with_the_methods(self):
        made = made_of(row("gauss_seidel", 1, 1, 0.5), row("gauss_seidel", 4, 4, 0.1))
        self.assertEqual(made.scenes(), ["line links=4"])
        (point, other), = made.curves("line links=4").values()
        self.assertEqual((point.unit, point.reference, point.work), ("row visit", "rest", 4))
        self.assertEqual(made.point("line links=4", "gauss_seidel", sweeps=4).error, other.error)

    def test_a_scene_or_a_row_that_is_not_there_is_an_error(self):
        made = made_of(row("gauss_seidel", 1, 1, 0.5))
        with self.assertRaises(SystemExit):
            made.curves("line links=5")
        with self.assertRaises(SystemExit):
            made.point("line links=4", "gauss_seidel", sweeps=2)

    def test_the_front_has_what_nothing_beats_in_both(self):
        made = made_of(row("a", 1, 1, 0.5), row("a", 2, 2, 0.6), row("b", 1, 3, 0.1), row("b", 2, 3, 0.2),
                       row("c", 1, 0.5, "inf"))
        self.assertEqual([(p.time, p.error) for p in table.front(made.points)], [(1, 0.5), (3, 0.1)])

    def test_the_cost_of_an_error_lies_on_the_line_through_the_logarithms(self):
        made = made_of(row("a", 1, 1, 1e-1), row("a", 10, 10, 1e-3))
        curve = made.curves("line links=4")["4", "a"]
        self.assertAlmostEqual(table.to_reach(curve, 1e-2), math.sqrt(10))
        self.assertEqual(table.to_reach(curve, 0.5), 1)
        self.assertIsNone(table.to_reach(curve, 1e-4))

    def test_a_lucky_crossing_does_not_count(self):
        made = made_of(row("a", 1, 1, 1e-6), row("a", 2, 2, 1e-1), row("a", 4, 4, 1e-4))
        cost = table.to_reach(made.curves("line links=4")["4", "a"], 1e-3)
        self.assertTrue(2 < cost < 4, cost)

    def test_runs_of_a_scene_count_where_they_are_good_enough(self):
        made = made_of(row("a", 1, 1, 1e-3, scene="line_run"), row("a", 2, 2, 1e-1, scene="line_run"))
        self.assertEqual(table.to_reach(made.curves("line_run links=4")["4", "a"], 1e-2), 1)

    def test_the_line_of_the_yardstick_is_no_run(self):
        made = made_of(row("a", 1, 1, 0.5), "0,baseline,baseline,microseconds=2.3 unit=row_visit reference=none,,,1000,,1,0,finished")
        self.assertEqual((made.microseconds, len(made.points)), ("2.3", 1))
        self.assertIsNone(made_of(row("a", 1, 1, 0.5)).microseconds)

    def test_failures_reach_nothing(self):
        made = made_of(row("a", 1, 1, "inf", status="fell"))
        self.assertIsNone(table.to_reach(made.curves("line links=4")["4", "a"], 1e9))

    def test_the_slope_is_the_exponent(self):
        self.assertAlmostEqual(table.slope([(x, 7 * x ** -2.5) for x in (1, 2, 4, 8)]), -2.5)
        self.assertIsNone(table.slope([(1, 1), (2, 2)]))

    def test_the_cheapest_come_first(self):
        made = made_of(row("slow", 1, 9, 1e-5), row("quick", 1, 1, 1e-5), row("never", 1, 1, 0.5))
        self.assertEqual([entry[2] for entry in table.cheapest(made, "line links=4", 1e-4)], ["quick", "slow"])


if __name__ == "__main__":
    unittest.main()
