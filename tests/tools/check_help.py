# SPDX-License-Identifier: Apache-2.0
"""Help, the manual page, completion and docs/abut.md: all of them speak of each command and option.

usage: check_help.py ABUT DIRECT SCENES
"""

import pathlib
import re
import shutil
import subprocess
import unittest

import program
from program import run

DOCUMENT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "abut.md"
SHELLS = ("bash", "zsh", "fish")


def commands():
    """The words of each command, from the help."""
    lines = run("--help").stdout.split("\n\n")[0].splitlines()
    return [re.match(r"(?:usage:)? +abut ((?:-*[a-z]+ ?)+)", line)[1].strip() for line in lines]


def options():
    return re.findall(r"^  (--[a-z][a-z-]*)", run("--help").stdout, re.MULTILINE)


class Help(program.Case):
    def test_there_are_commands_and_options(self):
        self.assertIn("explain pair", commands())
        self.assertIn("--contacts", options())

    def test_each_command_has_a_help_of_its_own(self):
        for command in commands():
            if command.startswith("-"):
                continue
            with self.subTest(command=command):
                text = self.succeed(*command.split(), "--help").stdout
                self.assertTrue(text.startswith(f"usage: abut {command}"), text)
                for option in options():
                    taken = f"\n  {option} " in text
                    refused = f"has no option '{option}'" in run(*command.split(), option).stderr
                    self.assertNotEqual(taken, refused, option)

    def test_help_and_version(self):
        self.assertEqual(self.succeed("help").stdout, self.succeed("--help").stdout)
        self.assertEqual(self.succeed("-h").stdout, self.succeed("--help").stdout)

    def test_the_document_names_each_command_and_option(self):
        text = DOCUMENT.read_text(encoding="utf-8")
        for command in commands():
            self.assertIn(f"`abut {command}", text)
        for option in options():
            self.assertRegex(text, rf"\n\| `{option}[ `]")

    def test_each_status_is_told_everywhere(self):
        told = run("--help").stdout.split("exit status\n")[1]
        statuses = re.findall(r"^  (\d+) +(.*)", told, re.MULTILINE)
        self.assertEqual([status for status, _ in statuses], ["0", "1", "2", "3", "4", "130"])
        for status, meaning in statuses:
            self.assertIn(f"\n| {status} | ", DOCUMENT.read_text(encoding="utf-8"))
            self.assertIn(f".TP\n\\fB{status}\\fR\n{meaning}.\n", run("manual").stdout)

    def test_lines_fit(self):
        for line in run("--help").stdout.splitlines():
            self.assertLessEqual(len(line), 120, line)


class Manual(program.Case):
    def test_it_names_each_command_and_option(self):
        page = self.succeed("manual").stdout.replace("\\-", "-")
        for word in commands() + options():
            self.assertIn(f".TP\n\\fB{word}\\fR", page)

    @unittest.skipUnless(shutil.which("groff"), "groff is missing, which renders manual pages")
    def test_it_renders_without_a_warning(self):
        page = self.succeed("manual").stdout
        result = subprocess.run(["groff", "-man", "-ww", "-Tascii", "-rLL=100n"], input=page, capture_output=True, text=True,
                                check=False)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("explain pair SCENE A B", re.sub(r"\x1b\[\d*m|.\x08", "", result.stdout))


class Completion(program.Case):
    def script(self, shell):
        return self.succeed("completion", shell).stdout

    def test_it_lists_each_command_and_option(self):
        for shell in SHELLS:
            with self.subTest(shell=shell):
                text = self.script(shell)
                for word in commands():
                    for part in word.split():
                        self.assertRegex(text, rf"(?<![\w-]){re.escape(part)}(?![\w-])")
                for option in options():
                    self.assertRegex(text, rf"-l {option[2:]} " if shell == "fish" else rf"(?<![\w-]){option}(?![\w-])")

    def completed(self, *words):
        """What bash offers for the last word."""
        script = self.script("bash") + "\ncompopt() { :; }\n"
        quoted = " ".join(f"'{word}'" for word in words)
        script += f"COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; _abut; printf '%s\\n' \"${{COMPREPLY[@]}}\""
        result = subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True, cwd=self.folder)
        self.assertEqual(result.stderr, "")
        return result.stdout.split()

    @unittest.skipUnless(shutil.which("bash"), "bash is missing")
    def test_bash_completes(self):
        (self.folder / "scene.json").touch()
        self.assertEqual(self.completed("abut", "ch"), ["check"])
        self.assertEqual(self.completed("abut", "run", "--co"), ["--contacts"])
        self.assertEqual(self.completed("abut", "check", "--co"), [])
        self.assertEqual(self.completed("abut", "run", "sc"), ["scene.json"])
        self.assertEqual(self.completed("abut", "run", "--events", ""), ["scene.json"])
        self.assertEqual(self.completed("abut", "run", "--steps", ""), [])
        self.assertEqual(self.completed("abut", "explain", "pa"), ["pair"])
        self.assertEqual(self.completed("abut", "completion", "z"), ["zsh"])

    def test_shells_can_read_it(self):
        for shell in SHELLS:
            with self.subTest(shell=shell):
                if not shutil.which(shell):
                    self.skipTest(f"{shell} is missing, which reads its completion")
                result = subprocess.run([shell, "-n"], input=self.script(shell), capture_output=True, text=True, check=False)
                self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_an_unknown_shell_is_told(self):
        result = run("completion", "zhs")
        self.assertEqual(result.returncode, 1)
        self.assertIn("there are: bash, zsh, fish; did you mean 'zsh'?", result.stderr)


if __name__ == "__main__":
    program.main()
