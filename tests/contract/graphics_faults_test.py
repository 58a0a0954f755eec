"""A driver that fails in every way and at every moment: a message, exit code 4, no picture that shows something else, and no work lost."""

import os
import shutil
import struct
import subprocess
import time
import unittest

from command_line import NPSEE, SANITIZED, SOURCE, CommandLine

FAULTY = os.environ["FAULTY_OSMESA"]
MISSION = SOURCE / "tests/data/v1/thesis_default.rec"


class GraphicsFaults(CommandLine):
    #: What draws, with the file it draws into; and what fails there at one moment after the other.
    DRAWERS = (
        (("render", "small.npsee.json", "--time", "0.5", "--size", "96x64", "-o", "out.png"), ("compile", "link", "framebuffer", "memory", "lost", "uploads", "textures")),
        (("render", "small.npsee.json", "--time", "0.5", "--size", "96x64", "--quality", "fine", "-o", "out.exr"), ("compile", "lost")),
        (("render", "small.npsee.json", "--template", "--size", "96x64", "-o", "out.png"), ("compile", "lost")),
        (("replay", MISSION, "--render", "t=16.5,size=96x64", "-o", "out.png"), ("compile", "lost", "textures")),
        (("edit", "small.npsee.json", "--headless", "--size", "800x500", "--screenshot", "out.png"), ("compile", "framebuffer", "lost", "uploads")),
    )
    #: After how many calls that go well; later ones lie farther apart, for more is drawn between them.
    MOMENTS = (0, 1, 2, 4, 5, 9, 17, 40, 120, 1000, 10000)

    def setUp(self):
        super().setUp()
        self.preset(count=60, form="fire", size_mean=0.4)

    def fail_at(self, call, kind, moment=0):
        return self.run_npsee(*call, NPSEE_OSMESA=FAULTY, FAULTY_GL=kind, FAULTY_GL_AFTER=str(moment))

    def test_a_driver_without_use_is_told_of(self):
        for call, _ in self.DRAWERS:
            for kind, word in (("context", "no OpenGL 3.3"), ("current", "cannot be used"), ("version", "offers OpenGL 3.2, npsee needs 3.3")):
                with self.subTest(call=call, kind=kind):
                    before = self.files()
                    self.expect(4, self.fail_at(call, kind), word)
                    self.assertEqual(self.files(), before)

    def sweep(self, call, kind, good):
        """Fails at one moment after the other, until the whole picture is drawn before the fault comes."""
        out = self.folder / call[-1]
        for moment in self.MOMENTS:
            out.unlink(missing_ok=True)
            done = self.fail_at(call, kind, moment)
            if done.returncode == 0:
                self.assertEqual(out.read_bytes(), good, f"{kind} after {moment}: the picture shows something else")
                self.assertGreater(moment, 0, f"{kind} was never met")
                return
            self.expect(4, done, "driver" if kind not in ("compile", "link") else "shader")
            self.assertFalse(out.exists(), f"{kind} after {moment}: a picture was written")
        self.fail("the picture was never drawn")

    def test_a_picture_is_whole_or_there_is_none(self):
        for call, kinds in self.DRAWERS:
            self.assertEqual(self.run_npsee(*call).returncode, 0, call)
            good = (self.folder / call[-1]).read_bytes()
            for kind in kinds:
                with self.subTest(call=call, kind=kind):
                    self.sweep(call, kind, good)

    def test_pictures_that_were_drawn_before_stay(self):
        call = ("render", "small.npsee.json", "--frames", "0:0.9", "--fps", "10", "--size", "96x64", "--jobs", "1", "-o", "f_%02d.png")
        self.assertEqual(self.run_npsee(*call).returncode, 0)
        good = self.files()
        for path in self.folder.glob("f_*.png"):
            path.unlink()
        self.expect(4, self.fail_at(call, "lost", 25), "driver failed while drawing")
        left = [name for name in self.files() if name.startswith("f_")]
        self.assertTrue(0 < len(left) < 10, left)
        self.assertEqual({name: self.files()[name] for name in left}, {name: good[name] for name in left})
        self.expect(0, self.run_npsee(*call, "--resume"))
        self.assertEqual(self.files(), good)

    def test_the_editor_keeps_what_was_unsaved(self):
        places = self.places("kept")
        saved = (self.folder / "small.npsee.json").read_bytes()
        self.write("script.txt", "set a.speed_mean 61\nwait 40\nsave one.png\nsave two.png\n")
        done = self.run_npsee("edit", "small.npsee.json", "--headless", "--remember", "--script", "script.txt", NPSEE_OSMESA=FAULTY, FAULTY_GL="lost", FAULTY_GL_AFTER="30", **places)
        self.expect(4, done, "driver failed while drawing: GL_CONTEXT_LOST")
        self.assertEqual((self.folder / "small.npsee.json").read_bytes(), saved)
        self.write("script.txt", 'expect unsaved = 1\nclick "button:bring back"\nexpect a.speed_mean = 61\n')
        self.expect(0, self.run_npsee("edit", "--headless", "--remember", "--script", "script.txt", **places))

    def window(self, name):
        """A display whose pixels are a file in a folder of that name; what a window of the editor needs to be told."""
        (self.folder / name).mkdir()
        ours, its = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(its), "-fbdir", str(self.folder / name), "-screen", "0", "1024x700x24", "-nolisten", "tcp", "-noreset"], pass_fds=[its], stderr=subprocess.DEVNULL)
        self.addCleanup(server.wait)
        self.addCleanup(server.kill)
        os.close(its)
        with os.fdopen(ours) as number:
            display = ":" + number.readline().strip()
        return {"DISPLAY": display, "LIBGL_ALWAYS_SOFTWARE": "1"}

    def places(self, run):
        """Folders of its own for what an editor remembers."""
        return {f"XDG_{kind}_HOME": str(self.folder / run / kind) for kind in ("CONFIG", "STATE", "CACHE")}

    @unittest.skipIf(SANITIZED, "sanitizers want to be the first library that is loaded")
    def test_a_window_whose_context_is_lost_ends_with_a_message(self):
        done = self.run_npsee("edit", "small.npsee.json", "--size", "900x600", LD_PRELOAD=FAULTY, FAULTY_GL="lost", FAULTY_GL_AFTER="200", **self.window("server"), **self.places("lost"))
        self.expect(4, done, "the graphics driver has lost the window's pictures", "what was not saved is offered")

    def pixels(self, server):
        """What the window at the corner of that server's screen shows: rows of 900 pixels."""
        dump = (self.folder / server / "Xvfb_screen0").read_bytes()
        # X's own format of dumps: a header with its size, the bytes of a row and the number of colours; colours of 12 bytes; rows.
        header, row, colours = (struct.unpack_from(">I", dump, 4 * field)[0] for field in (0, 12, 19))
        first = header + 12 * colours
        return [dump[first + row * y:first + row * y + 4 * 900] for y in range(600)]

    def eventually(self, done, what):
        deadline = time.monotonic() + 90
        while not done():
            self.assertLess(time.monotonic(), deadline, what)
            time.sleep(0.1)

    def act(self, variables, *words):
        """One order of xdotool's. Orders that follow a search in the same call are sent to that window as events, of which the last find it gone if one of them closed it."""
        done = subprocess.run(["xdotool", *words], env={**os.environ, **variables}, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, f"xdotool {' '.join(words)}: {done.stderr}")
        return done.stdout.strip()

    @unittest.skipIf(SANITIZED, "sanitizers want to be the first library that is loaded")
    @unittest.skipIf(shutil.which("xdotool") is None, "xdotool drives the window")
    def test_a_window_that_could_not_be_drawn_says_so_and_is_drawn_whole_again(self):
        call = ("edit", "small.npsee.json", "--size", "900x600", "--time", "0.5")
        self.write("nothing.txt", "no preset")
        self.write("script.txt", f"drop {self.folder}/nothing.txt\nwait 3\nprint items\n")
        items = self.expect(0, self.run_npsee(*call, "--headless", "--script", "script.txt")).stdout
        (place,) = [line.split()[1] for line in items.splitlines() if line.endswith(" button:dismiss")]
        column, row = (int(number) for number in place.split(","))
        editors = {}
        for name, fault in (("good", {}), ("faulty", {"LD_PRELOAD": FAULTY, "FAULTY_GL": "memory", "FAULTY_GL_AFTER": "20", "FAULTY_GL_CALLS": "9"})):
            variables = self.window(name)
            self.act(variables, "mousemove", "1020", "690")
            editor = subprocess.Popen([NPSEE, *call, "--print-state"], cwd=self.folder, env={**os.environ, **variables, **fault, **self.places(name)}, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.addCleanup(editor.communicate)
            self.addCleanup(editor.kill)
            editors[name] = editor, variables

        def told(server):
            """True where the red edge of an error's strip is, at the height of its button."""
            line = self.pixels(server)[row]
            return any(line[at + 2] > 150 and line[at + 2] > 2 * max(line[at:at + 2]) for at in range(4 * 230, 4 * 260, 4))

        def top(server):
            return self.pixels(server)[:20]

        # The menus are drawn in both, and the message in one.
        self.eventually(lambda: len(set(b"".join(top("good"))[::61])) >= 8 and top("faulty") == top("good"), "a window shows nothing")
        self.eventually(lambda: told("faulty"), "the driver's fault is not told")
        self.assertFalse(told("good"))
        windows = {name: self.act(variables, "search", "--name", "^small - npsee$") for name, (_, variables) in editors.items()}
        _, variables = editors["faulty"]
        self.act(variables, "mousemove", "--window", windows["faulty"], str(column), str(row))
        self.act(variables, "mousedown", "1")
        self.act(variables, "mouseup", "1")
        self.act(variables, "mousemove", "1020", "690")
        self.eventually(lambda: self.pixels("faulty") == self.pixels("good"), "what could not be drawn is missing")
        for name, (editor, variables) in editors.items():
            self.act(variables, "windowfocus", "--sync", windows[name])
            self.act(variables, "key", "ctrl+q")
            _, err = editor.communicate(timeout=60)
            self.assertEqual(editor.returncode, 0, err)


if __name__ == "__main__":
    unittest.main()
