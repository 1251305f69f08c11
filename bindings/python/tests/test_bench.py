"""The tasks that are compared with other libraries (bench/python): what fmb answers is right."""

import pathlib
import sys
import unittest

BENCH = pathlib.Path(__file__).resolve().parents[3] / "bench/python"


class Tasks(unittest.TestCase):
    def test_answers(self):
        sys.path.append(str(BENCH))
        import tasks
        import with_fmb
        self.assertEqual(len(tasks.TASKS), 20)
        no = {"strict"}  # there is no solution
        for name, _, given, judge in tasks.TASKS:
            self.assertEqual(judge(getattr(with_fmb, name)(*given)) is False, name in no, name)


if __name__ == "__main__":
    unittest.main()
