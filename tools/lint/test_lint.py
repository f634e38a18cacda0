#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Each rule of the lint fires on a bad snippet and is silent on a good one."""

import unittest

from lint import findings_of, judge, judge_ratchet, lowered
from members import borrowed_members
from rules import FILE_RULES, HARD_LENGTH, count_unsafe, is_long
from source import Source, strip_cxx, strip_hash
from tree_rules import TREE_RULES

MODULE = "modules/narrow/apart/gjk.cppm"
FOREIGN = '''module;
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Weverything"
{}
#pragma clang diagnostic pop
'''

# rule: (path, bad snippet, good snippet)
SNIPPETS = {
    "raw_memory": [
        ("capi/a.cpp", "memcpy(a, b, 8);", "copy(a, b);"),
        ("tests/capi/a.cpp", "memcpy(a, b, 8);", "copy(a, b);"),
        (MODULE, "void f() { std::memcpy(a, b, n); }", "void f() { std::ranges::copy(a, b); } // memcpy(a, b, n)"),
        (MODULE, "auto n = strlen(p);", 'auto n = s.size(); log("strlen(p)");'),
    ],
    "unsafe_word": [
        (MODULE, "auto* p = reinterpret_cast<int*>(q);", "auto p = std::bit_cast<int>(q);"),
        (MODULE, "auto p = new Thing;", "#include <new>\nauto p = std::make_unique<Thing>(); // new"),
        (MODULE, "void f() { delete p; }", "Thing(const Thing&) = delete;"),
        (MODULE, "void f() { delete[] p; }", "Thing(const Thing&) =\n    delete;"),
        (MODULE, "std::unique_ptr<int[]> p;", "std::unique_ptr<int> p;"),
        (MODULE, "std::shared_ptr<int> p;", "std::unique_ptr<int> p;"),
        (MODULE, "union U { int a; };", "int set_union = 0;"),
        (MODULE, "goto end;", "return;"),
    ],
    "unsafe_block": [
        ("capi/a.cpp", "ABUT_UNSAFE_BEGIN\nf();\nABUT_UNSAFE_END", "// SAFETY: f is fine.\nABUT_UNSAFE_BEGIN\nf();\nABUT_UNSAFE_END"),
        (
            "capi/a.cpp",
            "// SAFETY:\nABUT_UNSAFE_BEGIN\nABUT_UNSAFE_END",
            "// SAFETY: a reason\n// of two lines\nABUT_UNSAFE_BEGIN\nABUT_UNSAFE_END",
        ),
        ("capi/a.cpp", "// SAFETY: open\nABUT_UNSAFE_BEGIN\n", "#define ABUT_UNSAFE_BEGIN _x"),
        ("capi/a.cpp", "ABUT_UNSAFE_END", "int ABUT_UNSAFE_ENDING;"),
    ],
    "unsafe_place": [
        (MODULE, "// SAFETY: no\nABUT_UNSAFE_BEGIN\nABUT_UNSAFE_END", "int x;"),
    ],
    "silenced_warning": [
        (MODULE, '#pragma clang diagnostic ignored "-Wall"', "#pragma once"),
        ("tests/unit/a.cpp", '_Pragma("GCC diagnostic push")', "int pragma;"),
        (MODULE, FOREIGN.format("int x;"), FOREIGN.format("#include <Foreign>\n#include <foreign.h>")),
    ],
    "library_owner": [
        (MODULE, "#include <Eigen/Dense>", "#include <array>\n// #include <Eigen/Dense>"),
        ("modules/universe/step.cppm", "#include <embree3/rtcore.h>", "#include <vector>"),
        ("modules/shapes/box.cppm", "#include <ccd/ccd.h>", "#include <libqhull_r/qhull_ra.h>"),
    ],
    "module_path": [
        (MODULE, "export module abut.narrow.polytope.epa;", "export module abut.narrow.apart.gjk;"),
        ("modules/core/core.cppm", "export module abut.math;", "export module abut.core;"),
        ("modules/shapes/a_b.cppm", "export module abut.shape.a_b;", "export module abut.shapes.a_b;"),
        ("modules/shapes/a_absent/a.cppm", "export module abut.shapes.a_absent;", "export module abut.shapes.a;"),
    ],
    "interface_linkage": [
        (MODULE, "export module abut.narrow.apart.gjk;\nnamespace { int x; }", "export module abut.narrow.apart.gjk;\nnamespace abut { int x; }"),
    ],
    "standard_include": [
        (MODULE, "module;\n#include <vector>", "module;\n#include <Eigen/Dense>\n#include \"core/check.hpp\""),
        (MODULE, "#include <cmath>", "import abut.core.standard;"),
        ("modules/core/core.cppm", "#include <array>", "// #include <array>"),
    ],
    "bare_tolerance": [
        ("modules/narrow/fan/sat.cppm", "if (x > 1e-9) {", "constexpr Real least = 1e-9;\nif (x > least) {  // 1e-9"),
        ("modules/narrow/fan/sat.cppm", "const Real slack = 16 * epsilon * size;", "const Real slack = rounding_of(size);"),
    ],
    "include_order": [
        ("tests/unit/a.cpp", "import abut.core;\n#include <vector>", "#include <vector>\nimport abut.core;"),
    ],
    "macro": [
        (MODULE, "#define SQUARE(x) ((x) * (x))", "constexpr int square(int x) { return x * x; }"),
        (MODULE, "#define ABUT_A_HPP 1", "#define ABUT_A_HPP\n#endif"),
    ],
    "length": [
        (MODULE, "int x;\n" * (HARD_LENGTH + 1), "int x;\n\n" * HARD_LENGTH),
    ],
    "flag": [
        ("tests/CMakeLists.txt", "set(options -Wno-shadow)", "set(options --warn) # -Wno-shadow"),
        ("cmake/install.cmake", "set(x -fno-exceptions)", "set(x a-fno-exceptions)"),
        ("CMakeLists.txt", "target_compile_options(a PRIVATE x)", "target_compile_definitions(a PRIVATE X=1)"),
        ("CMakePresets.json", '{"CMAKE_CXX_FLAGS": ""}', '{"CMAKE_BUILD_TYPE": "Release"}'),
        ("CMakeLists.txt", "set(x -O3 -march=native)", "set(x --Output)"),
    ],
    "word": [
        ("docs/a.md", "see /" + "tmp/x", "see <build>/tmp/x"),
        ("scripts/a.sh", "cd /" + "root", 'cd "$root/root"'),
        ("docs/a.md", "TO" + "DO: more", "todos"),
        (MODULE, "// FIX" + "ME", "// fixed"),
    ],
    "line_length": [
        (MODULE, "// " + "x" * 118, "// " + "x" * 117),
        ("include/abut/a.h", "int a;" + " " * 115, "int a;"),
    ],
    "sentence_length": [
        (MODULE, "// " + "one two three four five\n// " * 6 + "end.", "// " + "one two three four five.\n// " * 6 + "end."),
        (MODULE, "/* " + "a " * 26 + "*/\n// " + "a " * 26, "int a;  // " + "a " * 26),
        (MODULE, "// - " + "a " * 20 + "\n//   " + "b " * 6, "// - " + "a " * 20 + "\n// - " + "b " * 20),
    ],
    "prose_length": [
        ("docs/a.md", "word " * 26 + ".", "word " * 20 + ".\n" + "word " * 20 + "."),
        ("docs/a.md", "- " + "word " * 20 + "\n  " + "word " * 6, "- " + "word " * 20 + "\n- " + "word " * 20),
        ("docs/a.md", "| " + "word " * 26 + "|", "| " + "word " * 20 + "| " + "word " * 20 + "|"),
        ("docs/a.md", "[" + "word " * 26 + "](a.md)", "```\n" + "word " * 26 + "\n```"),
        ("README.md", "word " * 26, "`" + "word " * 26 + "`\n\n    " + "word " * 26),
        ("README.md", "word " * 26, "![" + "word " * 26 + "](a.svg)"),
        ("docs/b.md", "word " * 26, "# " + "word " * 5 + "\n" + "word " * 22),
    ],
    "concept_place": [
        (MODULE, "template <class S>\nconcept Edged = true;", "// concept Edged = true;"),
        ("modules/pairs/rows/a.cppm", "template <class S>\nconcept Edged = true;", "concepts();"),
    ],
    "licence_line": [
        (MODULE, "// What this is for.", "// SPDX-License-Identifier: Apache-2.0\n// What this is for."),
        ("scripts/a", "#!/bin/sh\n# What this is for.\n# SPDX-License-Identifier: Apache-2.0", "#!/bin/sh\n# SPDX-License-Identifier: Apache-2.0"),
    ],
    "closed_source": [
        (MODULE, "// Source: SPEC VX-07", "// Source: Gottschalk, \"Separating axis theorem\", 1996"),
    ],
    "test_name": [
        ("tests/unit/a.cpp", "TEST(Sphere, is_round) {}", "TEST(Sphere, IsRound) {}"),
        ("tests/unit/a.cpp", "TYPED_TEST(Shape_All, IsRound) {}", "TYPED_TEST(AllShapes, IsRound) {}"),
    ],
}

HEADER = "include/abut/abut.h"
REGISTRY = "cmake/registry.cmake"
BOX = {"modules/shapes/box.cppm": "class Box {};", REGISTRY: "abut_shape(box Box 1)"}

LAYERED = {
    "modules/core/core.cppm": "export module abut.core;",
    "modules/capability/capability.cppm": "export module abut.capability;\nexport import abut.capability.records;",
    "modules/capability/records.cppm": "export module abut.capability.records;\nimport abut.core;",
    "modules/shapes/box.cppm": "export module abut.shapes.box;\nimport abut.capability;",
    "modules/pairs/rows/dispatch.cppm": "export module abut.pairs.rows.dispatch;",
    "modules/abut.cppm": "export module abut;\nexport import abut.pairs.registry;",
    "modules/pairs/registry/registry.cppm.in": "export module abut.pairs.registry;",
    MODULE: "export module abut.narrow.apart.gjk;\nimport :part;\nimport abut.capability;\nimport std;",
}

TABLE = {
    "modules/narrow/apart/gjk.cppm": "export module abut.narrow.apart.gjk;",
    "modules/narrow/warm/pair_memory.cppm": "export module abut.narrow.warm.pair_memory;",
    "modules/narrow/cast/cast.cppm": "export module abut.narrow.cast.cast;\nimport abut.narrow.apart.gjk;",
    "modules/pairs/table.cppm": "export module abut.pairs.table;\nimport abut.narrow.warm.pair_memory;",
    "modules/universe/universe.cppm": "export module abut.universe;\nimport abut.pairs.table;",
    "modules/pairs/rows/dispatch.cppm": "export module abut.pairs.rows.dispatch;\nimport abut.narrow.apart.gjk;",
}

USED = {
    "modules/core/core.cppm": "export module abut.core;\nexport namespace abut {\nstruct Pose { int inner; };\ninline int twice(int x) { return 2 * x; }\n}",
    "modules/math/math.cppm": "export module abut.math;\nexport import abut.core;",
}

# rule: (bad tree, good tree)
TREES = {
    "unused_import": [
        ({**USED, MODULE: "import abut.core;\nint inner;"}, {**USED, MODULE: "import abut.core;\nPose pose;"}),
        ({**USED, MODULE: "import abut.math;\n// twice"}, {**USED, MODULE: "import abut.math;\nint x = twice(1);"}),
    ],
    "kernel_reach": [
        ({**TABLE, "modules/pairs/any_shape/a.cppm": "import abut.narrow.cast.cast;"}, TABLE),
        ({**TABLE, "capi/a.hpp": "import abut.pairs.rows.dispatch;", "capi/a.cpp": ""}, {**TABLE, "capi/a.hpp": "import abut.universe;"}),
        (
            {**TABLE, "modules/universe/a.hpp": "", "modules/universe/step.cpp": "module abut.universe;\nimport abut.narrow.apart.gjk;"},
            {**TABLE, "modules/universe/step.cpp": "module abut.universe;\nimport abut.narrow.warm.pair_memory;"},
        ),
    ],
    "layer_order": [
        ({**LAYERED, MODULE: "import abut.pairs.rows.dispatch;"}, LAYERED),
        ({**LAYERED, MODULE: "export import abut.pairs.registry;"}, {**LAYERED, "modules/universe/a.cppm": "import abut.pairs.registry;"}),
        ({**LAYERED, MODULE: "import abut;"}, {**LAYERED, "tests/unit/a.cpp": "import abut;"}),
        ({**LAYERED, MODULE: "import abut.helpers;"}, {**LAYERED, MODULE: "// import abut.helpers;"}),
        ({**LAYERED, "modules/capability/records.cppm": "import abut.shapes.box;"}, {**LAYERED, "modules/universe/a.cppm": "import abut.shapes.box;"}),
        ({**LAYERED, "modules/misc/a.cppm": ""}, {**LAYERED, "modules/broadphase/a.cppm": ""}),
    ],
    "room_size": [
        ({f"modules/math/a{i}.cppm": "" for i in range(15)}, {f"modules/math/a{i}.cppm": "" for i in range(14)}),
        ({f"modules/math/a/b{i}.cpp": "" for i in range(15)}, {f"modules/math/{i % 2}/b{i}.cpp": "" for i in range(28)}),
    ],
    "glossary": [
        ({"docs/glossary.md": "| term | meaning |\n| a | b |\n| a | c |"}, {"docs/glossary.md": "| term | meaning |\n| a | b |\n\n| term | meaning |\n| c | a |"}),
    ],
    "registry": [
        ({REGISTRY: "abut_shape(box Box 1)"}, BOX),
        ({**BOX, REGISTRY: "abut_shape(box Box 1)\nabut_shape(box Box 2)"}, BOX),
        (
            {**BOX, "modules/shapes/ball.cppm": "", REGISTRY: "abut_shape(box Box 1)\nabut_shape(ball Ball 1)"},
            {**BOX, "modules/shapes/ball.cppm": "", REGISTRY: "abut_shape(box Box 1)\nabut_shape(ball Ball 2)"},
        ),
        ({**BOX, "modules/shapes/ball.cppm": ""}, {**BOX, "modules/shapes/box/faces.cppm": ""}),
    ],
    "sees_shapes": [
        ({"modules/universe/a.cpp": "import abut.pairs.registry;"}, {"modules/universe/a.cpp": "import abut.pairs.shape_handle;"}),
        ({"capi/a.hpp": "import abut.shapes.box;"}, {"modules/pairs/rows/a.cpp": "import abut.shapes.box;"}),
    ],
    "shape_name": [
        ({**BOX, "modules/universe/a.cppm": "Box b;"}, {**BOX, "modules/universe/a.cppm": "Boxes b; // Box"}),
        ({**BOX, "modules/universe/a.cppm": "class Box;\nBox b;"}, {**BOX, "modules/universe/a.cppm": "class alignas(8) Box {};\nBox b;"}),
        ({**BOX, "modules/universe/a.cppm": "import abut.shapes.box;"}, {**BOX, "modules/universe/a.cppm": "import abut.capability;"}),
        ({**BOX, "capi/a.cpp": 'kind("box");'}, {**BOX, "capi/shapes/shape.cpp": 'kind("box");'}),
        ({**BOX, "modules/universe/a.cpp": 'kind("box");'}, {**BOX, "modules/response/a.cpp": 'kind("box");'}),
        ({**BOX, "modules/shapes/ball.cppm": "Box b;"}, {**BOX, "modules/shapes/box/faces.cppm": "Box b;"}),
    ],
    "header": [
        ({HEADER: "ABUT_API bool f(void);"}, {HEADER: "ABUT_API uint32_t f(void); /* a bool */"}),
        ({HEADER: "ABUT_API long f(void);"}, {HEADER: "ABUT_API int64_t f(void);"}),
        ({HEADER: "ABUT_API void f(enum abut_x x);"}, {HEADER: "enum abut_x ABUT_ENUM(int32_t) { ABUT_A = 0 };"}),
        ({HEADER: "typedef struct a { size_t n; } a;"}, {HEADER: "ABUT_API size_t f(void);"}),
        ({HEADER: "typedef struct a { uint32_t n : 3; } a;"}, {HEADER: "typedef struct a { uint32_t n; } a;"}),
        ({HEADER: "typedef struct a { double x[]; } a;"}, {HEADER: "typedef struct a { double x[3]; } a;"}),
        ({HEADER: "union u;"}, {HEADER: "struct reunion;"}),
        ({HEADER: "ABUT_API void f(const char *format, ...);"}, {HEADER: "ABUT_API void f(const char *text);"}),
        ({HEADER: "#include <stdbool.h>"}, {HEADER: "#include <stdint.h>"}),
    ],
    "symbol_list": [
        ({HEADER: "ABUT_API void abut_f(void);", "capi/symbols.txt": ""}, {HEADER: "ABUT_API void abut_f(void);", "capi/symbols.txt": "abut_f\n"}),
        ({HEADER: "", "capi/symbols.txt": "abut_f\n"}, {HEADER: "", "capi/symbols.txt": ""}),
        (
            {HEADER: "ABUT_API void abut_f(void);\nABUT_API int32_t abut_e(void);", "capi/symbols.txt": "abut_f\nabut_e\n"},
            {HEADER: "ABUT_API void abut_f(void);\nABUT_API const char *abut_e(void);", "capi/symbols.txt": "abut_e\nabut_f\n"},
        ),
    ],
}

# what a class body holds, and whether it stores something borrowed
MEMBERS = [
    ("std::span<const double> points_;", True),
    ("std::string_view name;", True),
    ("const Thing* thing_ = nullptr;", True),
    ("Thing& thing_;", True),
    ("std::vector<const Thing*> things_;", True),
    ("Thing* thing_{nullptr};", True),
    ("[[maybe_unused]] int* p;", True),
    ("static constexpr std::string_view name = \"box\";", False),
    ("double radius_ = 2 * 3;", False),
    ("double scale_{a * b};", False),
    ("std::unique_ptr<Thing> thing_;", False),
    ("Thing& thing();", False),
    ("const Thing* find(int i) const { Thing* t = at(i); return t; }", False),
    ("explicit Box(const Vec3& v) : half_{v * 2} { int* p = f(); }", False),
    ("friend bool operator==(const Box&, const Box&) = default;", False),
    ("using reference = Thing&;", False),
    ("std::array<double, 3> x{}; Thing&& take() &&;", False),
    ("template <class T> void visit(T&& t) { t(1); }", False),
    ("enum class Kind { a, b }; Kind kind;", False),
    ("template <class F> const T& get(F&& f) const { if (!made) { return *value_; } return f(); }", False),
    ("template <class T> struct Inner { const T* p; };", True),
    ("void (*call)(void* user);", False),
    ("std::function<void(int&)> call;", True),
]


def fired(files):
    found = findings_of([Source(path, text) for path, text in files.items()])
    return {rule for rule, _, _, _ in found}


class Lint(unittest.TestCase):
    def test_each_rule_fires_and_is_silent(self):
        for rule, cases in SNIPPETS.items():
            for path, bad, good in cases:
                with self.subTest(rule=rule, bad=bad[:60]):
                    self.assertIn(rule, fired({path: bad}))
                    self.assertNotIn(rule, fired({path: good}))
        for rule, cases in TREES.items():
            for bad, good in cases:
                with self.subTest(rule=rule, bad=bad):
                    self.assertIn(rule, fired(bad))
                    self.assertNotIn(rule, fired(good))

    def test_each_rule_has_a_case(self):
        names = {rule.__name__ for rule in FILE_RULES + TREE_RULES} - {"borrowed_member"}
        self.assertEqual(names, SNIPPETS.keys() | TREES.keys())

    def test_members(self):
        for body, borrowed in MEMBERS:
            for kind in ("class Box final : public Base<int*> {", "template <class T>\nstruct Box {", "struct alignas(16) Box {"):
                code = f"namespace abut {{\n{kind}\n public:\n  {body}\n}};\nvoid f(int* p) {{ int* q = p; }}\n}}\n"
                with self.subTest(body=body, kind=kind):
                    self.assertEqual(bool(list(borrowed_members(code))), borrowed)
        self.assertEqual(list(borrowed_members("struct A {\n  int a;\n  int* b;\n};")), [(3, "*")])
        self.assertEqual(list(borrowed_members("struct [[gsl::Pointer]] A {\n  int* a;\n  struct B {\n    int* b;\n  };\n};")), [(4, "*")])
        self.assertIn("borrowed_member", fired({MODULE: "struct A { int* b; };"}))

    def test_stripping_keeps_lines(self):
        text = 'int a; // "x\n/* memcpy(\n */ auto s = "// no \\" comment"; int b = 1\'000; char c = \'"\'; auto r = R"(\n"/*)";\nint d;'
        stripped = strip_cxx(text, strings=True)
        self.assertEqual(len(text), len(stripped))
        self.assertEqual(text.count("\n"), stripped.count("\n"))
        self.assertNotIn("memcpy", stripped)
        self.assertNotIn("no", stripped)
        for code in ("int a;", "int b = 1'000;", "char c", "int d;"):
            self.assertIn(code, stripped)
        self.assertIn("// no", strip_cxx(text, strings=False))
        self.assertEqual(strip_hash('a "#b" # c'), 'a "#b"    ')

    def test_the_list_is_a_ratchet(self):
        found = [("length", "a.cpp", 1, "601 lines")]
        self.assertEqual(judge(found, "# why\nlength a.cpp  # one table\n"), [])
        self.assertEqual(judge(found, ""), ["a.cpp:1: length: 601 lines"])
        self.assertIn("has become clean", judge([], "length a.cpp  # one table")[0])
        self.assertIn("expected `rule path  # reason`", judge([], "length a.cpp")[0])
        self.assertIn("there is no rule", judge([], "lenght a.cpp  # one table")[0])

    def test_counts_only_become_less(self):
        found = [("line_length", "a.cpp", 1, "121 columns"), ("line_length", "a.cpp", 2, "122 columns")]
        self.assertEqual(judge_ratchet(found, "# why\nline_length a.cpp 2\n"), [])
        self.assertEqual(len(judge_ratchet(found, "line_length a.cpp 1\n")), 2)
        self.assertEqual(len(judge_ratchet(found, "")), 2)
        self.assertIn("2 left of 3", judge_ratchet(found, "line_length a.cpp 3\n")[0])
        self.assertEqual(lowered(found, "# why\nline_length a.cpp 3\nline_length b.cpp 1\n"), "# why\nline_length a.cpp 2\n")
        self.assertEqual(lowered(found, "line_length a.cpp 1\n"), "line_length a.cpp 1\n")

    def test_counts(self):
        self.assertEqual(count_unsafe(Source("capi/a.cpp", "ABUT_UNSAFE_BEGIN // ABUT_UNSAFE_BEGIN\nABUT_UNSAFE_END")), 1)
        self.assertTrue(is_long(Source("a.cpp", "x\n" * 301)))
        self.assertFalse(is_long(Source("a.cpp", "x\n" * 300)))


if __name__ == "__main__":
    unittest.main()
