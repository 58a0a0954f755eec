"""Files made to do harm, through the real command line: each ends with a message and its exit code, in bounded time and memory, writes
nothing and prints nothing that a terminal would obey."""

import json
import os
import resource
import struct
import unittest
import zlib

from command_line import SANITIZED, SOURCE, CommandLine

ESCAPE = "\x1b]0;owned\x07\x1b[2J"
#: Addresses a refusal may take: a bomb that is unpacked first does not fit.
BOUND = () if SANITIZED else ((resource.RLIMIT_AS, 2 << 30),)


def png(width, height, rows, kind=2, depth=8, tail=b"", compressed=None):
    """A PNG whose header says width x height, with these bytes as its picture."""

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    header = struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + tail + chunk(b"IDAT", compressed if compressed is not None else zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


class Hostile(CommandLine):
    def mission(self, **more):
        scenario = json.loads((SOURCE / "assets/missions/thesis_default.mission.json").read_text())
        for key, value in more.items():
            scenario[key] = value
        return self.write("m.mission.json", json.dumps(scenario))


class Paths(Hostile):
    def test_a_mission_names_nothing_outside_its_folder(self):
        for key in ("weapons", "facts", "rules"):
            for path in ("../secret.dat", "/etc/passwd", "a/../../secret.dat", "\\..\\secret", "./../secret.dat"):
                with self.subTest(key=key, path=path):
                    self.mission(**({key: path} if key != "rules" else {"observers": [{"id": "fo1", "rules": path}]}))
                    done = self.run_npsee("mission", "m.mission.json", "--until", "1")
                    self.assertEqual(done.returncode, 3, done.stderr)
                    self.assertNotIn("root:", done.stdout + done.stderr)
                    self.expect_harmless(done)

    def test_terrain_and_burst_presets_stay_in_the_folder_too(self):
        for world in ({"terrain": {"kind": "hgt", "file": "/etc/passwd"}}, {"terrain": {"kind": "png", "file": "../x.png"}}):
            self.mission(world=world)
            self.assertEqual(self.run_npsee("mission", "m.mission.json", "--until", "1").returncode, 3)
        scenario = json.loads((SOURCE / "assets/missions/hills_patrol.mission.json").read_text())
        scenario.pop("weapons", None)
        scenario["batteries"][0]["preset"] = "../../etc/passwd"
        self.write("m.mission.json", json.dumps(scenario))
        self.expect(3, self.run_npsee("mission", "m.mission.json", "--until", "1"), "preset")

    def test_links_lead_to_regular_files_only(self):
        for name, target in (("zero.dat", "/dev/zero"), ("self.dat", "self.dat"), ("tty.dat", "/dev/stdin"), ("folder.dat", "/")):
            with self.subTest(name=name):
                os.symlink(target, self.folder / name)
                self.mission(weapons=name)
                self.expect(3, self.run_npsee("mission", "m.mission.json", "--until", "1", limits=BOUND), name)

    def test_devices_and_pipes_are_no_presets(self):
        os.mkfifo(self.folder / "pipe.npsee.json")
        for path in ("/dev/zero", "pipe.npsee.json", "/proc/self/mem", "."):
            with self.subTest(path=path):
                self.assertEqual(self.run_npsee("particles", path, "--time", "1", limits=BOUND, seconds=20).returncode, 3)

    def test_a_link_in_the_place_of_an_output_is_followed_and_nothing_beside_it_is_touched(self):
        self.preset()
        self.write("precious.csv", "kept")
        self.expect(0, self.run_npsee("particles", "small.npsee.json", "--time", "1", "-o", "new.csv"))
        self.assertEqual((self.folder / "precious.csv").read_text(), "kept")
        self.assertEqual(set(self.files()), {"small.npsee.json", "precious.csv", "new.csv"})

    def test_a_recording_cannot_lead_elsewhere(self):
        text = (SOURCE / "tests/data/v1/thesis_default.rec").read_text()
        for folder in ("/etc", "../../../../etc", "\x00", ESCAPE):
            self.write("r.rec", text.replace('"folder":"."', '"folder":' + json.dumps(folder)))
            done = self.run_npsee("replay", "r.rec")
            self.assertIn(done.returncode, (0, 3))
            self.expect_harmless(done)


class Numbers(Hostile):
    HUGE = ("1e308", "-1e308", "1e999", "-1e999", "9" * 400, "18446744073709551616", "-9223372036854775809", "1e-320", "0.1e-999999999999", "NaN", "Infinity")

    def test_gigantic_numbers_in_a_preset(self):
        for number in self.HUGE:
            for key in ("count", "speed_mean", "size_mean", "lifetime_mean", "bounce_limit"):
                self.write("n.npsee.json", '{"npsee": 1, "layers": [{"name": "a", "count": 4, "%s": %s}]}' % (key, number) if key != "count" else '{"npsee": 1, "layers": [{"name": "a", "count": %s}]}' % number)
                with self.subTest(key=key, number=number[:30]):
                    done = self.run_npsee("particles", "n.npsee.json", "--time", "1", limits=BOUND, seconds=30)
                    self.assertIn(done.returncode, (0, 3))
                    self.assertNotRegex(done.stdout, r"\b(nan|inf)\b")
                    self.expect_harmless(done)

    def test_gigantic_numbers_in_a_mission(self):
        for number in self.HUGE:
            for key, text in (("duration", '{"npsee_mission": 1, "duration": %s}'), ("size", '{"npsee_mission": 1, "world": {"size": [%s, 1000]}}'), ("vehicles", '{"npsee_mission": 1, "vehicles": [{"id": "a", "type": 51, "pos": [%s, 0]}]}'),
                              ("count", '{"npsee_mission": 1, "groups": [{"id": "g", "type": 51, "count": %s, "from": [0, 0], "to": [10, 10]}]}')):
                self.write("n.mission.json", text % number)
                with self.subTest(key=key, number=number[:30]):
                    done = self.run_npsee("mission", "n.mission.json", "--until", "1", limits=BOUND, seconds=30)
                    self.assertIn(done.returncode, (0, 3))
                    self.expect_harmless(done)

    def test_gigantic_numbers_on_the_command_line(self):
        self.preset()
        for number in self.HUGE:
            for call in (("particles", "small.npsee.json", "--time", number), ("particles", "small.npsee.json", "--time", "1", "--set", "a.count=" + number), ("fly", "--v0", number, "--qe", "0.7rad"),
                         ("aim", "--v0", "300", "--range", number), ("render", "small.npsee.json", "--size", number + "x" + number, "-o", "x.png"), ("render", "small.npsee.json", "--frames", "0:" + number, "-o", "x.png", "--dry-run"),
                         ("particles", "small.npsee.json", "--time", "1", "--seed", number)):
                with self.subTest(call=" ".join(call)[:80]):
                    done = self.run_npsee(*call, limits=BOUND, seconds=30)
                    self.assertIn(done.returncode, (0, 1, 2, 3))
                    self.expect_harmless(done)

    def test_more_than_the_memory_is_refused_before_it_is_taken(self):
        layers = [{"name": "a", "count": 4000000, "bounce_limit": 64}]
        self.write("much.npsee.json", json.dumps({"npsee": 1, "layers": layers}))
        self.expect(3, self.run_npsee("particles", "much.npsee.json", "--time", "1", limits=BOUND), "MiB", "Lower")
        layers = [{"name": "a", "count": 40000}, {"name": "b", "parent": "a", "trigger": "bounce", "count": 40000}]
        self.write("much.npsee.json", json.dumps({"npsee": 1, "layers": layers}))
        self.expect(3, self.run_npsee("particles", "much.npsee.json", "--time", "1", limits=BOUND), "particles, above the limit")


class Shapes(Hostile):
    def test_deep_nesting(self):
        for text in ("[" * 200000, '{"a":' * 200000, '{"npsee":1,"layers":' + "[" * 200000 + "]" * 200000 + "}"):
            self.write("deep.npsee.json", text)
            self.write("deep.mission.json", text)
            self.write("deep.rec", text)
            self.assertEqual(self.run_npsee("particles", "deep.npsee.json", "--time", "1", limits=BOUND).returncode, 3)
            self.assertEqual(self.run_npsee("mission", "deep.mission.json", limits=BOUND).returncode, 3)
            self.assertEqual(self.run_npsee("replay", "deep.rec", limits=BOUND).returncode, 3)
        self.write("deep.clp", "(" * 200000)
        self.assertEqual(self.run_npsee("check", "deep.clp", limits=BOUND).returncode, 1)

    def test_very_long_names_and_very_many_things(self):
        self.write("long.npsee.json", json.dumps({"npsee": 1, "title": "x" * 10_000_000, "layers": []}))
        self.expect(3, self.run_npsee("particles", "long.npsee.json", "--time", "1", limits=BOUND))
        self.write("many.npsee.json", json.dumps({"npsee": 1, "layers": [{"name": f"l{i}", "count": 1} for i in range(100_000)]}))
        done = self.expect(3, self.run_npsee("particles", "many.npsee.json", "--time", "1", limits=BOUND))
        self.assertLess(len(done.stderr), 1 << 20)
        cycle = [{"name": "a", "parent": "b", "trigger": "death", "count": 1}, {"name": "b", "parent": "a", "trigger": "death", "count": 1}]
        self.write("cycle.npsee.json", json.dumps({"npsee": 1, "layers": cycle}))
        self.expect(3, self.run_npsee("particles", "cycle.npsee.json", "--time", "1"))

    def test_an_empty_file_and_bytes_that_are_no_text(self):
        for data in (b"", b"\x00" * 100, b"\xff\xfe\x00", bytes(range(256)) * 8, b"\xef\xbb\xbf{}"):
            for name, call in (("x.npsee.json", ("particles", "x.npsee.json", "--time", "1")), ("x.mission.json", ("mission", "x.mission.json")), ("x.rec", ("replay", "x.rec")), ("x.dat", ("weapons", "x.dat")),
                               ("x.png", ("compare", "x.png", "x.png")), ("x.json", ("fly", "--projectile", "./x.json", "--v0", "300", "--qe", "0.5rad"))):
                self.write(name, data)
                with self.subTest(name=name, data=data[:8]):
                    done = self.run_npsee(*call)
                    self.assertEqual(done.returncode, 0 if name == "x.dat" and not data else 3, done.stderr)
                    self.expect_harmless(done)


class Pictures(Hostile):
    def bombs(self):
        yield "a size that does not fit anything", png(2**31 - 1, 2**31 - 1, b"")
        yield "a square of 40,000 pixels in a few kB", png(40000, 40000, b"", compressed=zlib.compress(b"\0" * 50_000_000, 9))
        yield "one row of a million million pixels", png(1_000_000, 1_000_000, b"")
        yield "a text that unpacks to a gigabyte", png(1, 1, b"\0\0\0\0", tail=b"".join(chunk(b"zTXt", b"k\0\0" + zlib.compress(b"x" * 100_000_000, 9)) for _ in range(4)))
        yield "a colour profile that does", png(1, 1, b"\0\0\0\0", tail=chunk(b"iCCP", b"k\0\0" + zlib.compress(b"x" * 100_000_000, 9)))
        yield "a text that says it has 1.5 GB", png(1, 1, b"\0\0\0\0", tail=struct.pack(">I", 1_560_281_166) + b"tEXt" + b"x" * 80)
        yield "rows that end early", png(64, 64, b"\0" * 10)
        yield "data that is no deflate", png(64, 64, b"", compressed=b"\xff" * 100)

    def test_compare_unpacks_no_bomb(self):
        for name, data in self.bombs():
            with self.subTest(name=name):
                self.write("a.png", data)
                done = self.run_npsee("compare", "a.png", "a.png", limits=BOUND, seconds=60)
                self.assertIn(done.returncode, (0, 3), done.stderr)
                self.expect_harmless(done)

    def test_terrain_unpacks_no_bomb(self):
        for name, data in self.bombs():
            with self.subTest(name=name):
                self.write("t.png", data)
                self.mission(world={"terrain": {"kind": "png", "file": "t.png"}})
                done = self.run_npsee("mission", "m.mission.json", "--until", "1", limits=BOUND, seconds=60)
                self.assertIn(done.returncode, (0, 3), done.stderr)
                self.expect_harmless(done)


class Terminals(Hostile):
    """Names that would rename the window, clear the screen or forge a line of output."""

    def test_in_presets(self):
        for key in ("title", "description", "tags"):
            self.write("t.npsee.json", json.dumps({"npsee": 1, key: "x" + ESCAPE, "layers": [{"name": "a", "count": 3}]}))
            for call in (("particles", "t.npsee.json", "--time", "1"), ("check", "t.npsee.json"), ("render", "t.npsee.json", "--size", "64x64", "-o", "x.png")):
                done = self.run_npsee(*call)
                self.assertIn(done.returncode, (0, 1, 3))
                self.expect_harmless(done)
        for text in (json.dumps({"npsee": 1, "layers": [{"name": ESCAPE, "count": 3}]}), json.dumps({"npsee": 1, ESCAPE: 1}), json.dumps({"npsee": 1, "layers": [{"name": "a", "form": ESCAPE}]}),
                     json.dumps({"npsee": 1, "layers": [{"name": "b", "count": 1, "parent": ESCAPE}]}), '{"npsee": 1, "\x9b2J": 1}', '{"npsee": 1 \x1b[2J}'):
            self.write("t.npsee.json", text)
            self.expect(3, self.run_npsee("particles", "t.npsee.json", "--time", "1"))
            # JSON in a pipe has every byte as JSON writes it; a terminal gets no control character.
            self.assertNotRegex(self.run_on_terminal("check", "t.npsee.json", "--json"), rb"\x1b|\x07|\xc2[\x80-\x9f]")

    def test_in_missions_and_recordings(self):
        base = json.loads((SOURCE / "assets/missions/thesis_default.mission.json").read_text())
        vehicle = dict(base["vehicles"][0])
        variants = [{"name": ESCAPE}, {"title": ESCAPE}, {"description": ESCAPE}, {"vehicles": [{**vehicle, "id": ESCAPE}]}, {"weapons": ESCAPE}, {ESCAPE: 1}]
        for variant in variants:
            self.write("t.mission.json", json.dumps({**base, **variant}))
            done = self.run_npsee("mission", "t.mission.json", "--until", "60", "--record", "t.rec")
            self.assertIn(done.returncode, (0, 3))
            self.expect_harmless(done)
            self.expect_harmless(self.run_npsee("check", "t.mission.json"))
            if (self.folder / "t.rec").exists():
                for option in ((), ("--events",), ("--at", "10"), ("--format", "csv", "-o", "-"), ("--format", "acmi", "-o", "-")):
                    self.expect_harmless(self.run_npsee("replay", "t.rec", *option))
                (self.folder / "t.rec").unlink()
        recording = (SOURCE / "tests/data/v1/thesis_default.rec").read_text()
        for old in ('"id":"t72-1"', '"title":"The thesis\'s default"', '"ev":"call"', '"npsee_recording"', '"mission":'):
            self.write("t.rec", recording.replace(old, old.split(":")[0] + ":" + json.dumps(ESCAPE) if ":" in old and not old.endswith(":") else json.dumps(ESCAPE) + (":" if old.endswith(":") else "")))
            for option in ((), ("--events",)):
                self.expect_harmless(self.run_npsee("replay", "t.rec", *option))

    def test_in_weapons_rules_and_projectiles(self):
        weapons = (SOURCE / "assets/weapons.dat").read_text()
        self.write("w.dat", weapons.replace("I ", "I " + ESCAPE, 1) + "\nI " + ESCAPE + " 3\n# " + ESCAPE)
        self.expect_harmless(self.run_npsee("weapons", "w.dat"))
        self.expect_harmless(self.run_npsee("check", "w.dat"))
        self.write("r.clp", f'(defrule {ESCAPE} => (assert (x "{ESCAPE}")))')
        self.expect_harmless(self.run_npsee("check", "r.clp"))
        shell = json.loads(next((SOURCE / "assets/projectiles").glob("*.json")).read_text())
        for key in list(shell)[:6]:
            self.write("p.json", json.dumps({**shell, key: ESCAPE}))
            self.expect_harmless(self.run_npsee("fly", "--projectile", "./p.json", "--v0", "300", "--qe", "0.5rad"))
            self.expect_harmless(self.run_npsee("check", "p.json"))

    def test_in_file_names_and_options(self):
        name = "a\x1b[2J\x07.npsee.json"
        self.preset(name)
        for call in (("particles", name, "--time", "1"), ("check", name), ("particles", "none" + ESCAPE, "--time", "1"), ("compare", ESCAPE, ESCAPE),
                     ("particles", name, "--time", ESCAPE), ("particles", name, "--time", "1", "--set", ESCAPE + "=1"), (ESCAPE,), ("render", "--" + ESCAPE), ("fly", "--charge", ESCAPE, "--qe", "0.5rad"),
                     ("mission", name), ("replay", name), ("weapons", name), ("params", ESCAPE), ("edit", name, "--headless", "--script", name), ("manual", ESCAPE)):
            with self.subTest(call=call):
                self.expect_harmless(self.run_npsee(*call))

    def test_results_are_bytes_in_a_pipe_and_harmless_on_a_terminal(self):
        name = "a\x1b[2J\x07.npsee.json"
        self.preset(name)
        call = ("particles", name, "--frames", "0:1", "--fps", "1", "-o", "out\x1b[2J.csv")
        self.assertEqual(self.run_npsee(*call).stdout, "out\x1b[2J_0000.csv\n", "a script gets the name of the file")
        self.assertIn(rb"out\x1b[2J_0000.csv", self.run_on_terminal(*call))
        shell = json.loads(next((SOURCE / "assets/projectiles").glob("*.json")).read_text())
        self.write("p.json", json.dumps({**shell, "title": ESCAPE}))
        for each in (call, ("check", name), ("render", name, "--size", "64x64", "-o", "out\x1b[2J.png"), ("fly", "--projectile", "./p.json", "--v0", "300", "--qe", "0.5rad")):
            shown = self.run_on_terminal(*each)
            for sequence in (b"\x1b[2J", b"\x1b]", b"\x07"):
                self.assertNotIn(sequence, shown)


if __name__ == "__main__":
    unittest.main()
