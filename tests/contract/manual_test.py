"""Manual pages and completion are made from the options themselves: nothing that --help tells is missing, and nothing is made up."""

import re
import shutil
import subprocess
import unittest

from command_line import NPSEE, SOURCE, CommandLine


def plain(page):
    """A page without man(7)'s marks."""
    return page.replace("\\-", "-").replace("\\fB", "").replace("\\fI", "").replace("\\fR", "").replace("\\e", "\\")


class Manual(CommandLine):
    def commands(self):
        return re.findall(r"^  ([a-z]+) {2,}", self.run_npsee("--help").stdout.split("Subcommands:")[1], re.M)

    def test_every_option_that_help_tells_stands_in_the_page(self):
        self.assertGreater(len(self.commands()), 11)
        for command in self.commands():
            page = plain(self.expect(0, self.run_npsee("manual", command)).stdout)
            for option in re.findall(r"(?<![\w-])--[a-z][a-z-]+", self.run_npsee(command, "--help").stdout.split("Options:")[1].split("Examples:")[0]):
                with self.subTest(command=command, option=option):
                    self.assertIn(option, page)

    def test_pages_are_written_and_man_has_nothing_to_say_against_them(self):
        self.expect(0, self.run_npsee("manual", "--pages", "man1"))
        pages = sorted(path.name for path in (self.folder / "man1").iterdir())
        self.assertEqual(pages, sorted(["npsee.1"] + [f"npsee-{command}.1" for command in self.commands()]))
        if shutil.which("groff") is None:
            self.skipTest("groff is not installed: the pages are not set")
        for page in pages:
            done = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z", self.folder / "man1" / page], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""), page)

    def test_the_exit_codes_are_those_of_the_readme(self):
        page = plain(self.run_npsee("manual").stdout)
        for code, meaning in re.findall(r"^\| (\d) \| (.*) \|$", (SOURCE / "README.md").read_text(), re.M):
            self.assertIn(f"{code}\n{meaning[0].upper()}{meaning[1:]}.", page)

    def test_a_command_that_does_not_exist_is_named(self):
        self.expect(2, self.run_npsee("manual", "rendr"), "rendr", "render")


class Completion(CommandLine):
    def completed(self, *words):
        """What bash would offer for the last word, as the sourced script says."""
        script = 'source <("$0" manual --bash); COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _npsee; printf "%s\\n" "${COMPREPLY[@]}"'
        done = subprocess.run(["bash", "-c", script, NPSEE, "npsee", *words], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.stderr, "")
        return set(done.stdout.split("\n")) - {""}

    def setUp(self):
        super().setUp()
        for name in ("one.npsee.json", "with blank.npsee.json", "two.mission.json", "other.json", "weapons.dat", "sub/three.npsee.json"):
            self.write(name, "{}")

    def test_commands(self):
        self.assertEqual(self.completed("ren"), {"render"})
        self.assertLess({"edit", "render", "mission", "replay"}, self.completed(""))
        self.assertIn("one.npsee.json", self.completed("on"), "a file alone opens the editor")

    def test_options(self):
        self.assertEqual(self.completed("render", "one.npsee.json", "--backg"), {"--background"})
        self.assertIn("--expect", self.completed("mission", "--"))
        self.assertNotIn("--expect", self.completed("render", "--"))

    def test_files_of_the_kind_that_the_command_reads(self):
        self.assertEqual(self.completed("render", ""), {"one.npsee.json", "with blank.npsee.json", "sub"})
        self.assertEqual(self.completed("mission", ""), {"two.mission.json", "sub"})
        self.assertEqual(self.completed("edit", "sub/"), {"sub/three.npsee.json"})
        self.assertIn("weapons.dat", self.completed("weapons", ""))
        self.assertIn("other.json", self.completed("particles", "one.npsee.json", "-o", ""), "an output may have any name")

    def test_choices(self):
        self.assertEqual(self.completed("mission", "--format", ""), {"text", "json"})


if __name__ == "__main__":
    unittest.main()
