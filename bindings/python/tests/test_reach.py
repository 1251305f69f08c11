"""What the library can do, Python can: every public function is used by the package, or stands here with
the reason why not. And every public name of the package is documented."""

import contextlib
import inspect
import io
import pathlib
import re
import unittest

import fmb

ROOT = pathlib.Path(__file__).resolve().parents[3]
FUNCTION = re.compile(r"FMB_API\b[^;{]*?\b(fmb_\w+)\s*\(", re.S)
COMMENT = re.compile(r"/\*.*?\*/", re.S)

ABSENT = {
    "streams: text and bytes go through memory": """
        fmb_evidence_read fmb_evidence_write fmb_evidence_tell fmb_generators_read
        fmb_generators_write fmb_mesh_read fmb_mesh_read_tetgen fmb_permutations_read fmb_polyhedron_read
        fmb_script_read fmb_sink_jsonl fmb_system_read fmb_system_read_graph fmb_system_write""",
    "numbers as doubles: they come from the exact ones": """
        fmb_box_ends fmb_box_nearest fmb_evidence_coordinate fmb_evidence_multiplier fmb_evidence_ray
        fmb_evidence_value fmb_evidence_term fmb_generators_coordinate fmb_optimum_coordinate
        fmb_optimum_nearest fmb_optimum_ray fmb_proximity_point fmb_proximity_shift fmb_proximity_time
        fmb_solver_point fmb_solver_conflict_multiplier""",
    "rows and objectives of one kind of number: text and whole matrices do": """
        fmb_system_add fmb_system_add_int fmb_system_add_terms fmb_system_add_terms_int fmb_solver_add
        fmb_solver_set_right fmb_system_set_objective fmb_system_set_objective_terms
        fmb_system_set_objective_terms_int fmb_system_get_objective_int fmb_system_matrix fmb_matrix_free
        fmb_generators_new fmb_generators_add fmb_generators_trouble fmb_system_rel""",
    "the answer's point and conflict: they are read from its evidence, which lives on": """
        fmb_solver_conflict fmb_solver_conflict_row fmb_solver_conflict_multiplier_text fmb_solver_point_text
        fmb_solver_row""",
    "single parts of claims: Proof.claims has them in words, Proof.to_text as numbers": """
        fmb_evidence_var fmb_evidence_side fmb_evidence_row fmb_evidence_rel fmb_evidence_terms
        fmb_evidence_term_text fmb_evidence_value_text fmb_evidence_ray_text fmb_optimum_sense""",
    "the checker's patience and expectations: `fmb check`": """
        fmb_check_within fmb_evidence_read_within fmb_evidence_meets fmb_evidence_meets_within fmb_evidence_parse_within
        fmb_patience_trouble""",
    "frames one by one, and counts: Frames has them all at once": """
        fmb_frames_new fmb_frames_test_row fmb_pair_count fmb_separates""",
    "meshes: faces of files, all pairs without trees, TetGen's two files": """
        fmb_mesh_face fmb_mesh_meet_pairs fmb_mesh_parse_tetgen fmb_mesh_format_text fmb_mesh_how_text""",
    "symmetries: `fmb project --symmetry`, `--classes`": """
        fmb_permutations_new fmb_permutations_free fmb_permutations_add fmb_permutations_trouble
        fmb_permutations_dim fmb_permutations_size fmb_permutations_image fmb_permutations_parse
        fmb_solver_set_symmetries fmb_symmetries_find fmb_rows_classes""",
    "marks of files for the command: project() is told what stays": """
        fmb_system_asks_projection fmb_system_is_kept fmb_system_set_kept fmb_polyhedron_parse
        fmb_lift_generators""",
    "words that the package has itself": "fmb_rel_text fmb_verdict_text fmb_rule_find",
    "rules in Python are asked at the end of rounds, with rows as a whole": """
        fmb_view_lowers fmb_view_uppers fmb_view_lower fmb_view_upper fmb_view_drop_larger
        fmb_view_drop_covered fmb_view_scratch fmb_view_implicit fmb_view_gone fmb_view_bases
        fmb_view_base_sign""",
    "one conjunction of a script: System.parse": "fmb_script_whole",
}


class Reach(unittest.TestCase):
    def setUp(self):
        self.sources = "".join(path.read_text(encoding="utf-8") for path in
                               [*(ROOT / "bindings/python/fmb").glob("*.py"), ROOT / "bindings/python/build_core.py"])

    def test_every_public_function(self):
        public = set()
        for header in (ROOT / "include/fmb").glob("*.h"):
            if header.name != "gmp.h":
                public |= set(FUNCTION.findall(COMMENT.sub("", header.read_text(encoding="utf-8"))))
        used = set(re.findall(r"\bfmb_\w+", self.sources))
        used |= {name for name in public if name.endswith("_free") and f'"{name[:-5]}"' in self.sources}
        absent = {name for names in ABSENT.values() for name in names.split()}
        self.assertEqual(sorted(public - used - absent), [], "no way from Python, and no reason")
        self.assertEqual(sorted(absent - public), [], "no such function")
        self.assertEqual(sorted(absent & set(re.findall(r"lib\.(fmb_\w+)", self.sources))), [], "it is used")

    def test_what_is_typed_runs(self):
        import typed
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertIsNotNone(typed.questions())
        self.assertTrue(typed.sets())
        self.assertEqual(typed.laboratory(), [])
        self.assertEqual(typed.sessions(), [False, True])

    def test_every_public_name_is_documented(self):
        from fmb import bridges, lab
        self.assertLessEqual(set(fmb.__all__), set(dir(fmb)))
        names = [(fmb, name) for name in [*fmb.__all__, *(n for some in fmb._LATER.values() for n in some)]]
        names += [(lab, name) for name in lab.__all__] + [(bridges, name) for name in (
            "from_cdd", "to_cdd", "linprog", "LinprogResult")]
        for module, name in names:
            try:
                thing = getattr(module, name)
            except ModuleNotFoundError:  # NumPy
                continue
            self.assertTrue(inspect.getdoc(thing), name)
            if inspect.isclass(thing):
                for member, value in vars(thing).items():
                    if not member.startswith("_") and (inspect.isfunction(value) or isinstance(
                            value, (property, classmethod, staticmethod))):
                        self.assertTrue(inspect.getdoc(getattr(thing, member)), f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
