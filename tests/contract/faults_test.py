"""A full disk, a folder that cannot be written, a file that vanishes, memory that does not suffice: a message and its exit code, and no
file is half written."""

import os
import resource
import subprocess
import unittest

from command_line import SANITIZED, SOURCE, CommandLine

V1 = SOURCE / "tests/data/v1"
#: A limit on the size of files acts as a disk that is full after so many bytes: the write fails with an error.
FULL = ((resource.RLIMIT_FSIZE, 2048),)


class Faults(CommandLine):
    #: The stack of a thread is as large as that of the program may become: so no thread finds a place.
    NO_THREADS = ((resource.RLIMIT_STACK, 1 << 50),)
    #: Every command that writes, and the file it writes.
    WRITERS = (
        (("particles", "small.npsee.json", "--time", "1", "-o", "out.csv"), "out.csv"),
        (("particles", "small.npsee.json", "--time", "1", "--format", "ply", "-o", "out.ply"), "out.ply"),
        (("render", "small.npsee.json", "--size", "320x200", "-o", "out.png"), "out.png"),
        (("render", "small.npsee.json", "--size", "320x200", "-o", "out.exr"), "out.exr"),
        (("render", "small.npsee.json", "--sheet", "2x2", "--size", "320x200", "-o", "out.png"), "out.png"),
        (("mission", "m.mission.json", "--quiet", "--until", "60", "--record", "out.rec"), "out.rec"),
        (("replay", "r.rec", "-o", "out.acmi"), "out.acmi"),
        (("replay", "r.rec", "-o", "out.csv"), "out.csv"),
        (("replay", "r.rec", "-o", "out.pcap"), "out.pcap"),
        (("weapons", "w.dat", "-o", "out.dat"), "out.dat"),
        (("edit", "small.npsee.json", "--headless", "--screenshot", "out.png"), "out.png"),
    )

    def setUp(self):
        super().setUp()
        self.preset(count=400)
        self.write("m.mission.json", (V1 / "thesis_default.mission.json").read_bytes())
        self.write("r.rec", (V1 / "thesis_default.rec").read_bytes())
        self.write("w.dat", (SOURCE / "assets/weapons.dat").read_bytes() + b"/* a comment that makes it longer */\n" * 200)

    def test_a_full_disk_leaves_the_old_file_whole(self):
        for call, name in self.WRITERS:
            with self.subTest(call=" ".join(call)):
                self.write(name, "the old file")
                before = self.files()
                self.expect(5, self.run_npsee(*call, limits=FULL), name)
                self.assertEqual(self.files(), before, "nothing is left over, nothing is changed")

    def test_a_full_disk_and_no_old_file_leaves_nothing(self):
        before = self.files()
        for call, name in self.WRITERS:
            with self.subTest(call=" ".join(call)):
                self.expect(5, self.run_npsee(*call, limits=FULL), name)
                self.assertEqual(self.files(), before)

    def test_a_place_that_is_no_folder_is_named(self):
        self.write("file", "no folder")
        for call, name in self.WRITERS:
            with self.subTest(call=" ".join(call)):
                self.expect(5, self.run_npsee(*(word.replace(name, "file/" + name) for word in call)), "file/" + name)

    def test_a_read_only_folder_is_named(self):
        (self.folder / "closed").mkdir(mode=0o555)
        # Root may write anywhere; nobody may not.
        user = 65534 if os.geteuid() == 0 else None
        self.folder.chmod(0o755)
        try:
            self.run_npsee("--version", user=user)
        except PermissionError:
            self.skipTest("root may write anywhere, and nobody else may run the program here")
        for call, name in self.WRITERS:
            with self.subTest(call=" ".join(call)):
                self.expect(5, self.run_npsee(*(word.replace(name, "closed/" + name) for word in call), user=user), "closed/" + name)

    def test_a_file_that_vanished_is_named(self):
        for call in (("particles", "gone.npsee.json", "--time", "1"), ("render", "gone.npsee.json", "-o", "x.png"), ("mission", "gone.mission.json"), ("replay", "gone.rec"), ("weapons", "gone.dat"), ("compare", "gone.png", "gone.png"),
                     ("edit", "gone.npsee.json", "--headless", "--screenshot", "x.png"), ("edit", "small.npsee.json", "--headless", "--script", "gone.txt")):
            with self.subTest(call=" ".join(call)):
                self.expect(3, self.run_npsee(*call), "gone.")
        os.symlink("gone.npsee.json", self.folder / "broken.npsee.json")
        self.expect(3, self.run_npsee("particles", "broken.npsee.json", "--time", "1"), "broken.")

    def test_a_kill_at_any_moment_leaves_every_file_old_or_new(self):
        for call, name in ((("mission", "m.mission.json", "--quiet", "--until", "60", "--record", "out"), "out"), (("particles", "small.npsee.json", "--time", "1", "-o", "out.csv"), "out.csv"),
                           (("render", "small.npsee.json", "--size", "160x90", "-o", "out.png"), "out.png")):
            self.assertEqual(self.run_npsee(*call).returncode, 0)
            new = (self.folder / name).read_bytes()
            # A timeout kills with SIGKILL. Whenever that is, the file must be one or the other.
            states = set()
            for moment in range(34):
                self.write(name, b"old")
                try:
                    self.run_npsee(*call, seconds=0.004 * (moment + 1))
                except subprocess.TimeoutExpired:
                    pass
                now = (self.folder / name).read_bytes()
                self.assertIn(now, (b"old", new), f"{' '.join(call)}, killed at moment {moment}")
                states.add(now == new)
            self.assertTrue(states)

    @unittest.skipIf(SANITIZED, "sanitizers want to be the first library that is loaded")
    def test_a_clock_that_jumps_changes_nothing(self):
        places = {f"XDG_{kind}_HOME": str(self.folder / ".kept") for kind in ("CONFIG", "STATE", "CACHE")}
        self.write("script.txt", "set a.speed_mean 61\nwait 31\nexpect autosaved = yes\nkey ctrl+S\nkey Space\nwait 30\nexpect dirty = no\nexpect error =\n")
        calls = ((("mission", "m.mission.json", "--quiet", "--until", "60", "--record", "out"), "out"),
                 (("render", "small.npsee.json", "--frames", "0:0.2", "--fps", "10", "--size", "96x64", "-o", "f_%d.png", "--progress", "steps"), "f_1.png"),
                 (("edit", "small.npsee.json", "--headless", "--remember", "--size", "800x500", "--script", "script.txt", "--screenshot", "out.png"), "out.png"))
        for call, name in calls:
            with self.subTest(call=" ".join(call)):
                self.preset(count=60)
                self.expect(0, self.run_npsee(*call, **places))
                steady = (self.folder / name).read_bytes()
                self.preset(count=60)
                self.expect(0, self.run_npsee(*call, LD_PRELOAD=os.environ["JUMPING_CLOCK"], **places))
                self.assertEqual((self.folder / name).read_bytes(), steady)

    @unittest.skipIf(SANITIZED, "sanitizers take addresses of their own")
    def test_memory_that_does_not_suffice_is_told(self):
        self.preset("big.npsee.json", count=3_000_000)
        done = self.run_npsee("particles", "big.npsee.json", "--time", "1", "-o", "out.csv", limits=((resource.RLIMIT_AS, 300 << 20),))
        self.expect(3, done, "memory")
        self.assertNotIn("out.csv", self.files())

    MANY_JOBS = (
        ("render", "small.npsee.json", "--time", "1", "--size", "64x64", "--jobs", "256", "-o", "out.png"),
        ("render", "small.npsee.json", "--frames", "0:0.2", "--fps", "10", "--size", "64x64", "--jobs", "256", "-o", "f_%d.png"),
        ("mission", "m.mission.json", "--until", "20", "--monte-carlo", "300", "--jobs", "1024"),
        ("replay", "r.rec", "--render", "t=10,size=64x64", "--render", "t=20,size=64x64", "-o", "m_%d.png"),
        ("particles", "small.npsee.json", "--time", "1", "-o", "out.csv"),
        ("table", "--projectile", "m107", "--charge", "8"),
        ("compare", "a", "b", "--jobs", "64"),
    )

    def set_up_many_jobs(self):
        self.preset(count=5000)
        for folder in ("a", "b"):
            for number in range(3):
                self.write(f"{folder}/{number}.png", (SOURCE / "tests/golden/passes").glob("*.png").__next__().read_bytes())

    @unittest.skipIf(SANITIZED, "sanitizers take addresses and threads of their own")
    def test_where_no_thread_can_be_started_the_result_is_the_same(self):
        if resource.getrlimit(resource.RLIMIT_STACK)[1] != resource.RLIM_INFINITY:
            self.skipTest("stacks may not grow so far here")
        self.set_up_many_jobs()
        for call in self.MANY_JOBS:
            with self.subTest(call=" ".join(call)):
                # The graphics driver has threads of its own, and does not ask whether they started.
                one, other = (self.run_npsee(*call, limits=limits, LP_NUM_THREADS="0") for limits in ((), self.NO_THREADS))
                self.expect(0, one)
                self.expect(0, other)
                self.assertEqual(other.stdout, one.stdout)

    @unittest.skipIf(SANITIZED, "sanitizers take addresses and threads of their own")
    def test_more_threads_than_the_memory_has_room_for_end_no_command(self):
        self.set_up_many_jobs()
        for call in self.MANY_JOBS:
            with self.subTest(call=" ".join(call)):
                self.with_little_memory(call, 2000)

    @unittest.skipIf(SANITIZED, "sanitizers take addresses and threads of their own")
    def test_missions_end_in_good_order_with_any_memory(self):
        self.write("grow.clp", """(deftemplate grown (slot number) (slot text))
            (defrule grow (not (grown)) =>
              (loop-for-count (?i 1 40000) (assert (grown (number ?i) (text (str-cat "a text of its own " ?i))))))""")
        self.write("g.mission.json", """{ "npsee_mission": 1, "name": "g", "duration": 60, "vehicles": [{ "id": "t", "type": 51, "pos": [26000, 25000] }],
            "observers": [{ "id": "fo1", "pos": [25000, 25000], "rules": "grow.clp", "missions": [{ "action": "destroy", "type": 51 }] }] }""")
        for memory_mb in (40, 50, 60, 64, 66, 68, 70, 72, 76, 80, 90, 100, 120, 150, 200, 300, 500, 700, 1000, 1500):
            for call in (("mission", "g.mission.json", "--until", "20"), ("mission", "m.mission.json", "--until", "20", "--monte-carlo", "40", "--jobs", "64")):
                with self.subTest(call=" ".join(call), memory_mb=memory_mb):
                    self.with_little_memory(call, memory_mb)

    def with_little_memory(self, call, memory_mb):
        done = self.run_npsee(*call, limits=((resource.RLIMIT_AS, memory_mb * 1_000_000),), LP_NUM_THREADS="0")
        self.assertIn(done.returncode, (0, 3), done.stderr[-2000:])
        self.assertTrue(done.returncode == 0 or "memory" in done.stderr, done.stderr)


if __name__ == "__main__":
    unittest.main()
