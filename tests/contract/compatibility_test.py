"""What version 1 wrote is read for ever, and what scripts rely on stays: exit codes, JSON keys, event names, file versions."""

import json
import sys
import unittest

from command_line import SOURCE, CommandLine

V1 = SOURCE / "tests/data/v1"


def keys_of(value, path=""):
    """Paths of all keys in a JSON value; a list counts as its elements."""
    if isinstance(value, dict):
        return {key for name, inner in value.items() for key in {f"{path}/{name}"} | keys_of(inner, f"{path}/{name}")}
    if isinstance(value, list):
        return {key for inner in value for key in keys_of(inner, path)}
    return set()


class Samples(CommandLine):
    def test_presets_missions_and_recordings_of_version_1_are_read(self):
        presets, missions = sorted(V1.glob("*.npsee.json")), sorted(V1.glob("*.mission.json"))
        self.assertEqual((len(presets), len(missions)), (3, 2))
        self.expect(0, self.run_npsee("check", *presets, *missions))
        for preset in presets:
            rows = self.expect(0, self.run_npsee("particles", preset, "--time", "1")).stdout.splitlines()
            self.assertGreater(len(rows), 100)
        for mission in missions:
            self.assertIn('"ev":"end"', self.expect(0, self.run_npsee("mission", mission, "--until", "30")).stdout)

    def test_a_recording_of_version_1_says_what_it_said(self):
        file = V1 / "thesis_default.rec"
        done = self.expect(0, self.run_npsee("replay", file, "--events"))
        events = [json.loads(line) for line in done.stdout.splitlines()]
        stored = [json.loads(line) for line in file.read_text().splitlines()]
        self.assertEqual(events[-1]["hash"], stored[0]["npsee_recording"]["hash"])
        self.assertEqual([event["ev"] for event in events], [line["event"]["ev"] for line in stored if "event" in line])
        state = json.loads(self.expect(0, self.run_npsee("replay", file, "--at", "10")).stdout)
        self.assertTrue(keys_of(state))

    def test_files_of_a_newer_version_are_refused_and_the_version_is_named(self):
        self.write("new.npsee.json", '{"npsee": 2, "new_key": 1}')
        self.write("new.mission.json", '{"npsee_mission": 3, "new_key": 1}')
        self.write("new.rec", (V1 / "thesis_default.rec").read_text().replace('"version":1', '"version":4'))
        self.expect(3, self.run_npsee("particles", "new.npsee.json", "--time", "1"), "version 2, newer than 1", "newer npsee")
        self.expect(3, self.run_npsee("mission", "new.mission.json"), "version 3, newer than 1", "newer npsee")
        self.expect(3, self.run_npsee("replay", "new.rec"), "version 4, newer than 1", "newer npsee")


class Pinned(CommandLine):
    """tests/data/v1/contract.json is what version 1.0 promised; there may be more, never less."""

    def setUp(self):
        super().setUp()
        self.contract = json.loads((V1 / "contract.json").read_text())

    def test_events_and_their_keys_stay(self):
        rows = json.loads(self.run_npsee("params", "--events", "--format", "json").stdout)
        now = {f"{row['event']}/{row['key']}:{row['type']}" for row in rows}
        self.assertFalse(set(self.contract["events"]) - now)

    def test_parameters_and_mission_keys_stay(self):
        rows = json.loads(self.run_npsee("params", "--format", "json").stdout)
        now = {f"{row['scope']}/{row['key']}:{row['type']}" for row in rows}
        self.assertFalse(set(self.contract["parameters"]) - now)
        schema = keys_of(json.loads(self.run_npsee("params", "--missions", "--format", "json").stdout))
        self.assertTrue(schema)

    def test_json_keys_stay(self):
        self.preset()
        for call, keys in self.contract["json"].items():
            with self.subTest(call=call):
                done = self.run_npsee(*call.replace("V1", str(V1)).split())
                self.assertFalse(set(keys) - keys_of(json.loads(done.stdout)))

    def test_columns_stay(self):
        self.preset()
        now = self.run_npsee("particles", "small.npsee.json", "--time", "0").stdout.splitlines()[0].split(",")
        self.assertEqual(now[: len(self.contract["columns"])], self.contract["columns"])

    def test_exit_codes_stay(self):
        self.preset()
        self.write("bad.npsee.json", "{")
        for call, code in self.contract["exit_codes"].items():
            with self.subTest(call=call):
                self.assertEqual(self.run_npsee(*call.replace("V1", str(V1)).split()).returncode, code)


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        # What is pinned, from the program as it is: for a new version's contract, not to make a test pass.
        from command_line import NPSEE
        import subprocess

        def told(call):
            return json.loads(subprocess.run([NPSEE, *call.replace("V1", str(V1)).split()], capture_output=True, text=True, check=False, cwd=V1).stdout)

        calls = ["fly --v0 300 --qe 0.7rad --json", "aim --v0 300 --range 5000 --json", "particles V1/cascade.npsee.json --time 1 --format json", "replay V1/thesis_default.rec --at 16.5",
                 "mission V1/thesis_default.mission.json --monte-carlo 2 --until 30 --format json", "check bad.npsee.json --json"]
        (V1 / "bad.npsee.json").write_text("{")
        pinned = {"events": sorted(f"{r['event']}/{r['key']}:{r['type']}" for r in told("params --events --format json")),
                  "parameters": sorted(f"{r['scope']}/{r['key']}:{r['type']}" for r in told("params --format json")),
                  "json": {call: sorted(keys_of(told(call))) for call in calls},
                  "columns": subprocess.run([NPSEE, "particles", V1 / "cascade.npsee.json", "--time", "0"], capture_output=True, text=True, check=True).stdout.splitlines()[0].split(","),
                  "exit_codes": {"check V1": 0, "--version": 0, "--help": 0, "check bad.npsee.json": 1, "aim --v0 300 --range 90km": 1, "nonsense": 2, "particles small.npsee.json": 2,
                                 "particles small.npsee.json --time 1 --set a.sped=1": 2, "particles bad.npsee.json --time 1": 3, "mission missing.mission.json": 3, "replay small.npsee.json": 3,
                                 "particles small.npsee.json --time 1 -o nowhere/x.csv": 5}}
        (V1 / "bad.npsee.json").unlink()
        (V1 / "contract.json").write_text(json.dumps(pinned, indent=1) + "\n")
    else:
        unittest.main()
