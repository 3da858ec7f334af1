#!/usr/bin/env python3
"""Which tests a source of loader/ has: x_test.cpp and x_gl_test.cpp for x.cpp, tests that include its header, and those
that the table below names for parts of a room that only the room's own functions use.

tests_of.py SOURCE...    the tests of each, as loader/check/graph/pass_graph_dot.cpp
tests_of.py --check      fails when a source has none, or a row of the table fits no source or names no file
"""
import fnmatch
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Sources without .cpp below loader/, tests below tests/. The first row that fits counts.
ROOMS = {
    "api/*": "api/renderer_gl_test.cpp",
    "app/commands/doctor": "app/chart_test.py",
    "app/commands/option_tree": "view/option_pages_test.cpp",
    "app/commands/tune": "app/chart_test.py",
    "app/commands/world_export": "app/export_test.py",
    "app/commands/*": "app/cases.py",
    "app/main": "app/man_test.py",
    "app/drawing/frame_probe": "app/probe_test.py",
    "app/drawing/*": "app/drawing_test.py",
    "app/gallery/*": "app/gallery_test.py",
    "app/input/world_shelf": "view/script_test.py",
    "app/input/*": "app/cases.py",
    "app/lsp/*": "app/lsp_test.py",
    "app/output/report*": "app/reports_test.py",
    "app/output/*": "app/cases.py",
    "app/study/*": "app/chart_test.py",
    "app/validate/*": "app/matrix_test.py",
    "app/view/apart/*": "view/apart_test.py",
    "app/view/script/*": "view/script_test.py",
    "app/view/surface/key_bindings": "view/view_controls_test.cpp",
    "app/view/*": "view/view_test.py",
    "app/window/*": "view/script_test.py",
    "chart/gallery/*": "chart/gallery_page_test.cpp",
    "chart/page/chart_files": "app/chart_test.py",
    "chart/page/*": "chart/chart_data_test.cpp",
    "chart/scenes/row_meter": "chart/scene_row_test.cpp",
    "chart/scenes/*": "app/chart_test.py",
    "chart/study/tune": "chart/tune_search_test.cpp",
    "chart/study/*": "app/chart_test.py",
    "check/compile/link_errors": "check/declaration_checks_test.cpp",
    "check/compile/*version*": "check/version_checks_test.cpp",
    "check/compile/stage_files": "check/version_table_test.cpp",
    "check/compile/target_limits": "check/version_checks_test.cpp",
    "check/compile/*": "check/program_check_test.cpp",
    "check/frame/format_checks": "check/hazard_checks_test.cpp",
    "check/frame/frame_passes": "check/hazard_checks_test.cpp",
    "check/frame/*": "check/frame_checks_test.cpp",
    "check/graph/*": "check/pass_graph_test.cpp",
    "check/hints/double_include": "validate/validate_pack_test.cpp",
    "check/hints/language_hints": "check/language_hints_test.cpp",
    "check/hints/*": "check/compile_hints_test.cpp",
    "check/ids/*": "check/id_checks_test.cpp",
    "check/interface/name_checks": "check/declaration_names_test.cpp",
    "check/interface/known_names": "check/declaration_names_test.cpp",
    "check/interface/sampler_checks": "check/declaration_names_test.cpp",
    "check/interface/*": "check/declaration_checks_test.cpp",
    "check/logs/*": "check/log_explainer_test.cpp",
    "check/matrix/*": "check/matrix_test.cpp",
    "check/pack/*": "check/text_checks_test.cpp",
    "check/rules/*": "check/rules_test.cpp",
    "check/workers/sandbox_*": "check/sandbox_test.cpp",
    "check/workers/*": "check/isolated_jobs_test.cpp",
    "core/files/*": "core/file_source_test.cpp",
    "core/socket_bytes": "view/apart_test.py",
    "core/parallel": "world/save_test.cpp",
    "gl/state_guard": "api/adopt_gl_test.cpp",
    "gl/*": "gl/context_gl_test.cpp",
    "glsl/iris/*": "glsl/iris_text_test.cpp",
    "glsl/preprocess/conditional*": "glsl/conditional_balance_test.cpp",
    "glsl/preprocess/*": "glsl/preprocessor_test.cpp",
    "glsl/rewrite/core_names": "glsl/core_text_test.cpp",
    "glsl/rewrite/subgroup_code": "glsl/subgroups_test.cpp",
    "glsl/rewrite/rewrite_shared_bounds": "glsl/shared_buffer_test.cpp",
    "glsl/rewrite/*": "glsl/rewrite_test.cpp",
    "glsl/syntax/brace_*": "glsl/conditional_balance_test.cpp",
    "glsl/syntax/nesting": "glsl/conditional_balance_test.cpp",
    "glsl/syntax/directive_slip": "glsl/conditional_balance_test.cpp",
    "glsl/syntax/*": "glsl/validate_test.cpp",
    "glsl/tokens/*": "glsl/token_test.cpp",
    "image/image_size": "app/cases.py",
    "image/*": "image/image_io_test.cpp",
    "pack/expressions/*": "pack/expression_test.cpp",
    "pack/files/*": "pack/shader_pack_test.cpp",
    "pack/mods/*": "pack/mods_test.cpp",
    "pack/options/*": "pack/options_test.cpp",
    "pack/programs/const_line": "pack/directives_test.cpp",
    "pack/programs/*directive*": "pack/directives_test.cpp",
    "pack/programs/program_reuse": "pack/rebuild_test.cpp",
    "pack/programs/*": "pack/shader_pack_test.cpp",
    "pack/properties/property_profiles": "pack/profile_test.cpp",
    "pack/properties/*": "pack/shader_properties_test.cpp",
    "pack/versions/*": "pack/iris_versions_test.cpp",
    "plan/frame/*": "plan/uniforms_test.cpp",
    "plan/lists/*": "plan/draw_lists_test.cpp",
    "plan/scene/*": "plan/vertex_packer_test.cpp",
    "plan/schedule/*": "plan/schedule_test.cpp",
    "render/draw/draw_shadow_volumes": "stability/volume_gl_test.cpp",
    "render/draw/draw_sky": "render/sky_gl_test.cpp",
    "render/draw/*": "render/draw_blocks_gl_test.cpp",
    "render/session/*": "render/session_change_gl_test.cpp",
    "render/*": "render/frame_renderer_gl_test.cpp",
    "report/*": "report/report_format_test.cpp",
    "trace/export/*": "app/export_test.py",
    "trace/film/*": "trace/film_test.cpp",
    "trace/grid/*": "trace/voxel_grid_test.cpp",
    "trace/*": "trace/furnace_test.cpp",
    "validate/driver_check": "app/cases.py",
    "validate/draw_check": "app/cases.py",
    "validate/edited_check": "app/lsp_test.py",
    "validate/*": "validate/validate_pack_test.cpp",
    "world/atlas/*": "world/block_atlas_test.cpp",
    "world/files/world_json_blocks": "world/world_json_test.cpp",
    "world/files/json_reader": "world/located_json_test.cpp",
    "world/files/tag_builds": "world/builds_test.cpp",
    "world/files/*": "world/schematic_test.cpp",
    "world/items/*": "world/item_looks_test.cpp",
    "world/luanti/*": "world/luanti_world_test.cpp",
    "world/mesh/*": "world/block_mesh_test.cpp",
    "world/resources/*": "world/block_models_test.cpp",
    "world/saved_things/*": "world/saved_things_test.cpp",
    "world/saves/*": "world/save_test.cpp",
    "world/*": "world/world_test.cpp",
}


def tests_by_header():
    """By header without .h below loader/: the tests that include it."""
    found = {}
    for test in sorted((ROOT / "tests").rglob("*.cpp")):
        for header in re.findall(r'#include [<"](?:orris/)?([\w/]+)\.h[>"]', test.read_text()):
            found.setdefault(header, []).append(str(test.relative_to(ROOT / "tests")))
    return found


def row_of(key):
    return next((pattern for pattern in ROOMS if fnmatch.fnmatch(key, pattern)), None)


def tests_of(key, by_header, files):
    """Of the source `key`, those of its own name first."""
    name = key.rsplit("/", 1)[-1]
    own = [file for file in files if re.fullmatch(rf"(.*/)?{name}(_gl)?_test\.(cpp|py)", file)]
    row = row_of(key)
    return own or by_header.get(key, []) or ([ROOMS[row]] if row else [])


def main():
    files = [str(file.relative_to(ROOT / "tests")) for file in sorted((ROOT / "tests").rglob("*_test.*"))]
    by_header = tests_by_header()
    keys = [str(file.relative_to(ROOT / "loader").with_suffix("")) for file in sorted((ROOT / "loader").rglob("*.cpp"))]
    if sys.argv[1:] != ["--check"]:
        for source in sys.argv[1:]:
            key = str(pathlib.Path(source).resolve().relative_to(ROOT / "loader").with_suffix(""))
            print(source, *("  tests/" + test for test in tests_of(key, by_header, files)), sep="\n")
        return 0
    problems = [f"{key}: no test" for key in keys if not tests_of(key, by_header, files)]
    used = {row_of(key) for key in keys}
    problems += [f"{row}: no source" for row in ROOMS if row not in used]
    problems += [f"{test}: no such test" for test in ROOMS.values() if not (ROOT / "tests" / test).is_file()]
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
