"""For tests in Python that drive the real command line: NPSEE in the environment is the built program, SOURCE the source tree."""

import os
import pathlib
import resource
import subprocess
import tempfile
import unittest

NPSEE = os.environ["NPSEE"]
SOURCE = pathlib.Path(os.environ["SOURCE"])
SANITIZED = os.environ.get("SANITIZED") == "1"


class CommandLine(unittest.TestCase):
    """A folder of its own for each test, and the program run in it."""

    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def run_npsee(self, *arguments, limits=(), seconds=120, user=None, **environment):
        """Outputs as text; `limits` are (resource, value) pairs for the child only."""

        def restrict():
            for what, value in limits:
                resource.setrlimit(what, (value, value))

        variables = {**os.environ, "DISPLAY": "", "WAYLAND_DISPLAY": "", **environment}
        return subprocess.run([NPSEE, *map(str, arguments)], cwd=self.folder, env=variables, capture_output=True, text=True, errors="replace",
                              timeout=seconds, check=False, user=user, preexec_fn=restrict if limits else None)

    def run_on_terminal(self, *arguments):
        """What the program shows on a terminal of its own, both outputs, as bytes."""
        import pty

        ours, its = pty.openpty()
        child = subprocess.Popen([NPSEE, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=its, stderr=its)
        os.close(its)
        shown = b""
        while True:
            try:
                piece = os.read(ours, 65536)
            except OSError:
                break
            if not piece:
                break
            shown += piece
        os.close(ours)
        child.wait()
        return shown

    def expect(self, code, done, *words):
        """The exit code, every word in the messages, and nothing a terminal would obey in either output."""
        self.assertEqual(done.returncode, code, done.stderr[-2000:])
        for word in words:
            self.assertIn(word, done.stderr)
        self.expect_harmless(done)
        return done

    def expect_harmless(self, done):
        for text in (done.stdout, done.stderr):
            bad = {c for c in text if (ord(c) < 0x20 and c not in "\n\t") or 0x7f <= ord(c) < 0xa0}
            self.assertFalse(bad, f"control characters {bad!r} are printed")

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def preset(self, name="small.npsee.json", count=5, layer="a", **more):
        import json

        return self.write(name, json.dumps({"npsee": 1, "layers": [{"name": layer, "count": count, **more}]}))

    def files(self):
        """Everything in the folder, by name, with its bytes."""
        return {str(path.relative_to(self.folder)): path.read_bytes() for path in sorted(self.folder.rglob("*")) if path.is_file()}
