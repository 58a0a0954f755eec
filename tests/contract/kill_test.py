"""kill -9 at random moments of everything that writes: afterwards every file is whole, old or new, what was unsaved is offered, and a render farm goes on
to the same bytes. NPSEE_KILLS=100 kills each a hundred times; the suite some times, at moments of a fixed seed."""

import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import time
import unittest

from command_line import NPSEE, SOURCE, CommandLine

V1 = SOURCE / "tests/data/v1"
KILLS = int(os.environ.get("NPSEE_KILLS", "4"))
SEQUENCE = ("render", "small.npsee.json", "--frames", "0:0.6", "--fps", "10", "--size", "160x90")


class Kills(CommandLine):
    def setUp(self):
        super().setUp()
        self.preset(count=400)
        self.write("m.mission.json", (V1 / "thesis_default.mission.json").read_bytes())
        self.places = {f"XDG_{kind}_HOME": str(self.folder / ".kept" / kind) for kind in ("CONFIG", "STATE", "CACHE")}

    def forget(self):
        """What an editor remembers is gone."""
        shutil.rmtree(self.folder / ".kept", ignore_errors=True)
        for place in self.places.values():
            pathlib.Path(place).mkdir(parents=True)

    def start(self, *call):
        return subprocess.Popen([NPSEE, *map(str, call)], cwd=self.folder, env={**os.environ, "DISPLAY": "", **self.places}, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def children_end(self):
        """What the killed program had started ends by itself; its command line names our folder."""
        for _ in range(1200):
            lines = [pathlib.Path(place, "cmdline") for place in os.listdir("/proc") if place.isdigit()]
            if not any(self.names_folder(pathlib.Path("/proc") / line) for line in lines):
                return
            time.sleep(0.05)
        self.fail("a child outlives the program that was killed")

    def names_folder(self, line):
        try:
            return str(self.folder).encode() in line.read_bytes()
        except OSError:
            return False

    def kill_at(self, moment_s, *calls):
        """Starts all, kills each, and waits until their children are gone too. What they printed, and how many were met alive."""
        running = [self.start(*call) for call in calls]
        time.sleep(moment_s)
        for one in running:
            one.send_signal(signal.SIGKILL)
        printed = [one.communicate(timeout=60)[0] for one in running]
        self.children_end()
        return printed, sum(one.returncode == -signal.SIGKILL for one in running)

    def moments(self, *calls):
        """Random moments between the start and somewhat after the end of an undisturbed run."""
        began = time.monotonic()
        for one in [self.start(*call) for call in calls]:
            out, err = one.communicate(timeout=120)
            self.assertEqual(one.returncode, 0, err)
        whole_s = time.monotonic() - began
        dice = random.Random(str(calls))
        return [1.05 * whole_s * dice.random() for _ in range(KILLS)]

    @staticmethod
    def until(moments, met):
        """The moments, and shares of the last of them, each smaller, until what `met` asks for has happened: what was measured on a machine that was
        busy just then tells little of the others."""
        yield from moments
        for step in range(1, 41):
            if met():
                return
            yield max(moments) * 0.8**step if step < 40 else 0.0

    def outputs(self):
        """Files that are no inputs, and not what the editor remembers."""
        return {name: data for name, data in self.files().items() if not name.startswith((".kept/", "small.", "m.mission", "script."))}

    def expect_old_or_new(self, new, old, moment):
        for name, data in self.outputs().items():
            last = pathlib.Path(name).name
            if last.startswith("."):
                # Left on the way to its own name: only ffmpeg writes into a file that has one before it is whole.
                whole = next((bytes_ for target, bytes_ in new.items() if last.startswith("." + pathlib.Path(target).name + ".")), None)
                self.assertIsNotNone(whole, f"killed after {moment} s: {name} is of nothing that was asked for")
                self.assertTrue(".mp4." in last or data == whole, f"killed after {moment} s: {name} is left, and not whole")
                (self.folder / name).unlink()
            else:
                self.assertIn(data, (old.get(name), new[name]), f"killed after {moment} s: {name} is neither old nor new")

    def expect_whole_files(self, *call):
        moments = self.moments(*[call])
        new = self.outputs()
        met = 0
        for number, moment in enumerate(self.until(moments, lambda: met > 0)):
            old = {name: b"old" for name in new} if number % 2 == 0 else {}
            for name in new:
                self.write(name, b"old") if old else (self.folder / name).unlink(missing_ok=True)
            met += self.kill_at(moment, call)[1]
            self.expect_old_or_new(new, old, moment)
        self.assertGreater(met, 0, "at least one was killed on the way")

    def test_a_mission_being_recorded(self):
        self.expect_whole_files("mission", "m.mission.json", "--quiet", "--until", "60", "--record", "out.rec")

    def test_particles_being_written(self):
        self.expect_whole_files("particles", "small.npsee.json", "--time", "1", "-o", "out.csv")

    def test_a_sequence_being_drawn(self):
        self.expect_whole_files(*SEQUENCE, "-o", "f_%02d.png")

    @unittest.skipIf(shutil.which("ffmpeg") is None, "videos need ffmpeg")
    def test_a_video_being_drawn(self):
        self.expect_whole_files(*SEQUENCE, "-o", "out.mp4")

    def test_a_render_farm_goes_on_to_the_same_bytes(self):
        farm = [(*SEQUENCE, "-o", "f_%02d.png", "--shard", f"{part}/2", "--resume") for part in (1, 2)]
        moments = self.moments(*farm)
        new = self.outputs()
        self.assertEqual(len(new), 6)
        for moment in moments:
            for name in self.outputs():
                (self.folder / name).unlink()
            self.kill_at(moment, *farm)
            self.expect_old_or_new(new, {}, moment)
            for part in farm:
                self.expect(0, self.run_npsee(*part))
            self.assertEqual(self.outputs(), new, f"killed after {moment} s, and gone on")

    def export(self, kind, size):
        """A script that exports beside the preset."""
        return (f'click "button:tour skip"\nset time 0.2\nclick menu:Export\nclick "item:Export {kind}"\nclick "field:export size"\nkey ctrl+A\ntype {size}\nkey Enter\n'
                f'click "field:export folder"\nkey ctrl+A\ntype {self.folder}/out\nkey Enter\nclick button:export\nexpect exports = 1\nsettle\nexpect error =\n')

    def test_an_export_of_the_editor(self):
        kinds = [("sequence", "96x54, 5 fps")] + ([("video", "96x54, 5 fps")] if shutil.which("ffmpeg") is not None else [])
        for kind, size in kinds:
            with self.subTest(kind=kind):
                shutil.rmtree(self.folder / "out", ignore_errors=True)
                self.forget()
                (self.folder / "out").mkdir()
                self.preset(count=60, lifetime_mean=0.5)
                self.write("script.txt", self.export(kind, size))
                call = ("edit", "small.npsee.json", "--headless", "--remember", "--script", "script.txt")
                moments = self.moments(call)
                new = self.outputs()
                self.assertGreater(len(new), 0)
                for moment in moments:
                    self.forget()
                    for name in new:
                        self.write(name, b"old")
                    self.kill_at(moment, call)
                    self.expect_old_or_new(new, {name: b"old" for name in new}, moment)

    def test_an_editor_that_saves(self):
        script = 'click "button:tour skip"\n'
        for step in range(30):
            script += f"set a.speed_mean {100 + step}\nwait 31\nprint a.speed_mean\n" + ("key ctrl+S\n" if step % 2 else "drag a.size_mean 20\n")
        call = ("edit", "small.npsee.json", "--headless", "--remember", "--script", "script.txt")
        self.write("script.txt", script)
        offered = 0
        for moment in self.until(self.moments(call), lambda: offered > 0):
            self.forget()
            self.preset(count=40, speed_mean=99)
            self.write("script.txt", script)
            (printed,), _ = self.kill_at(moment, call)
            reached = max([99.0, *(float(number) for number in re.findall(r"a\.speed_mean=([0-9.]+)", printed))])
            # Whole: read without a fault, and one of the states that were saved.
            self.expect(0, self.run_npsee("check", "small.npsee.json"))
            kept = self.speed_saved()
            self.assertTrue(kept == 99.0 or (kept - 100.0) % 2 == 1.0, f"{kept} was never saved")
            self.assertEqual(self.outputs(), {}, "nothing is left beside it")
            self.write("script.txt", "print unsaved\n")
            found = self.expect(0, self.run_npsee("edit", "--headless", "--remember", "--script", "script.txt", **self.places))
            if "unsaved=1" in found.stdout:
                offered += 1
                self.write("script.txt", 'click "button:bring back"\nexpect error =\nprint a.speed_mean\nkey ctrl+Q\nclick button:discard\n')
                back = self.expect(0, self.run_npsee("edit", "--headless", "--remember", "--script", "script.txt", **self.places))
                kept = max(kept, float(re.search(r"a\.speed_mean=([0-9.]+)", back.stdout)[1]))
            self.assertGreaterEqual(kept, reached, f"killed after {moment} s: what was on the screen half a second before is lost")
        self.assertGreater(offered, 0, "some were killed with unsaved work")

    def speed_saved(self):
        import json

        return float(json.loads((self.folder / "small.npsee.json").read_text())["layers"][0]["speed_mean"])


if __name__ == "__main__":
    unittest.main()
