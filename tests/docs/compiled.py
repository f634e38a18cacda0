# SPDX-License-Identifier: Apache-2.0
"""Blocks of C and C++: compiled as users compile them, linked to the shared libraries, and run."""

import concurrent.futures
import re
import shutil
import subprocess

# A fragment says what to call, not what to do with every value.
COMMON = ["-O0", "-Wall", "-Wextra", "-Werror", "-Wno-unused", "-Wno-unused-parameter"]
WAYS = {"c": ("cc", ["-std=c99", "-x", "c"], "names.h"), "cpp": ("c++", ["-std=c++17", "-x", "c++"], "names.hpp")}
INCLUDE = re.compile(r"^\s*#\s*include\b[^\n]*$", re.MULTILINE)


def is_program(block):
    return re.search(r"\bint\s+main\s*\(", block.code) is not None


def source_of(block, earlier):
    """A whole source: a program as it stands, a fragment in the function that names.h calls."""
    if is_program(block):
        return f'#line {block.line} "{block.page}"\n{block.code}'
    parts = [*earlier, block] if "continues" in block.markers else [block]
    outside, inside = [f'#include "{WAYS[block.language][2]}"'], []
    for part in parts:
        outside += INCLUDE.findall(part.code)
        code = f'#line {part.line} "{part.page}"\n' + INCLUDE.sub("", part.code)
        given = part.markers.get("given", "")
        if "file scope" in part.markers:
            outside += [given, code]
        else:
            inside += [given, code]
    return "\n".join([*outside, "void fragment(void) {", *inside, "}", ""])


class Compiler:
    def __init__(self, root, folder, libraries):
        self.root, self.folder, self.libraries = root, folder, libraries

    @staticmethod
    def missing(language):
        """The compiler that is not there, or None."""
        return None if shutil.which(WAYS[language][0]) else WAYS[language][0]

    def prepare(self):
        """Most of the time to compile a block of C++ goes into its headers, so they are read once."""
        header = self.folder / "headers.hpp"
        header.write_text("#include <abut/picking.hpp>\n#include <abut/response.hpp>\n", encoding="utf-8")
        subprocess.run(["c++", *WAYS["cpp"][1][:-1], "c++-header", *COMMON, f"-I{self.root / 'include'}", str(header),
                        "-o", f"{header}.gch"], check=True)

    def failure(self, block, earlier):
        """What is wrong with a block; empty when it does what it says."""
        name, options, _ = WAYS[block.language]
        stem = self.folder / re.sub(r"\W", "_", block.place)
        source, program = stem.with_suffix(f".{block.language}"), stem.with_suffix(".program")
        source.write_text(source_of(block, earlier), encoding="utf-8")
        first = ["-include", str(self.folder / "headers.hpp")] if block.language == "cpp" else []
        includes = [f"-I{self.root / 'include'}", f"-I{self.root / 'tests' / 'docs'}"]
        link = [str(library) for library in self.libraries] + [f"-Wl,-rpath,{library.parent}" for library in self.libraries]
        command = [name, *options, *COMMON, *first, *includes, str(source), "-x", "none", *link, "-o", str(program)]
        done = subprocess.run(command, check=False, capture_output=True, text=True)
        if done.returncode != 0:
            return f"{block.place}: does not compile\n{done.stderr}"
        if "no-run" in block.markers or "file scope" in block.markers:
            return ""
        try:
            done = subprocess.run([program], check=False, capture_output=True, text=True, timeout=60, cwd=self.folder)
        except subprocess.TimeoutExpired:
            return f"{block.place}: has not ended after a minute"
        if done.returncode != 0:
            return f"{block.place}: fails with {done.returncode}\n{done.stdout}{done.stderr}"
        return block.wrong_output(done.stdout)

    def failures(self, found):
        """Of all blocks of both languages; (checked, failures)."""
        jobs = []
        for block in found:
            earlier = [other for other in found if (other.page, other.language) == (block.page, block.language)
                       and other.line < block.line and not is_program(other)]
            # A block that stands at file scope for others is compiled with them and alone.
            jobs.append((block, self._chain(block, earlier)))
        if any(block.language == "cpp" for block, _ in jobs):
            self.prepare()
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            results = pool.map(lambda job: self.failure(*job), jobs)
            return len(jobs), [result for result in results if result]

    @staticmethod
    def _chain(block, earlier):
        """The blocks that one continues: those before it, back to the first that continues nothing."""
        chain = []
        for other in reversed(earlier):
            chain.insert(0, other)
            if "continues" not in other.markers:
                break
        return chain if "continues" in block.markers else []
