"""A driver that fails in every way and at every moment: a message, exit code 4, no picture that shows something else, and no work lost."""

import os
import subprocess
import unittest

from command_line import SANITIZED, SOURCE, CommandLine

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
        places = {f"XDG_{kind}_HOME": str(self.folder / kind) for kind in ("CONFIG", "STATE", "CACHE")}
        saved = (self.folder / "small.npsee.json").read_bytes()
        self.write("script.txt", "set a.speed_mean 61\nwait 40\nsave one.png\nsave two.png\n")
        done = self.run_npsee("edit", "small.npsee.json", "--headless", "--remember", "--script", "script.txt", NPSEE_OSMESA=FAULTY, FAULTY_GL="lost", FAULTY_GL_AFTER="30", **places)
        self.expect(4, done, "driver failed while drawing: GL_CONTEXT_LOST")
        self.assertEqual((self.folder / "small.npsee.json").read_bytes(), saved)
        self.write("script.txt", 'expect unsaved = 1\nclick "button:bring back"\nexpect a.speed_mean = 61\n')
        self.expect(0, self.run_npsee("edit", "--headless", "--remember", "--script", "script.txt", **places))

    @unittest.skipIf(SANITIZED, "sanitizers want to be the first library that is loaded")
    def test_a_window_whose_context_is_lost_ends_with_a_message(self):
        ours, its = os.pipe()
        display = subprocess.Popen(["Xvfb", "-displayfd", str(its), "-screen", "0", "1024x700x24", "-nolisten", "tcp"], pass_fds=[its], stderr=subprocess.DEVNULL)
        os.close(its)
        try:
            with os.fdopen(ours) as number:
                name = ":" + number.readline().strip()
            places = {f"XDG_{kind}_HOME": str(self.folder / kind) for kind in ("CONFIG", "STATE", "CACHE")}
            done = self.run_npsee("edit", "small.npsee.json", "--size", "900x600", DISPLAY=name, LIBGL_ALWAYS_SOFTWARE="1", LD_PRELOAD=FAULTY, FAULTY_GL="lost", FAULTY_GL_AFTER="200", **places)
            self.expect(4, done, "the graphics driver has lost the window's pictures", "what was not saved is offered")
        finally:
            display.kill()
            display.wait()


if __name__ == "__main__":
    unittest.main()
