"""The packages that cpack makes: what the .deb needs and holds, that it works unpacked in any folder, and that the source archive is whole."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

SOURCE, BUILD, CMAKE = pathlib.Path(os.environ["SOURCE"]), pathlib.Path(os.environ["BUILD"]), os.environ["CMAKE"]


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, errors="replace", check=False, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command} exits {done.returncode}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    return done.stdout


def cpack(config, folder, *options):
    run(pathlib.Path(CMAKE).with_name("cpack"), "--config", BUILD / config, "-B", folder, *options, cwd=folder)


@unittest.skipIf(shutil.which("dpkg-deb") is None or shutil.which("dpkg-shlibdeps") is None, "a .deb is built with dpkg-deb and dpkg-shlibdeps (dpkg-dev), which are not installed")
class DebianPackage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.kept.cleanup)
        folder = pathlib.Path(cls.kept.name)
        cpack("CPackConfig.cmake", folder, "-G", "DEB")
        (cls.deb,) = folder.glob("*.deb")
        cls.root = folder / "root"
        run("dpkg-deb", "-x", cls.deb, cls.root)
        cls.control = folder / "control"
        run("dpkg-deb", "-e", cls.deb, cls.control)
        cls.work = folder / "work"
        cls.work.mkdir()

    def npsee(self, *arguments):
        """The unpacked program, which must find its files beside itself; nothing of the source tree is in sight."""
        # What sanitizers are told goes along: in it stands which leaks are the graphics driver's.
        environment = {"PATH": "/usr/bin:/bin", "HOME": str(self.work), **{name: value for name, value in os.environ.items() if name.endswith("SAN_OPTIONS")}}
        return run(self.root / "usr/bin/npsee", *arguments, cwd=self.work, env=environment)

    def listed(self):
        return sorted(str(path.relative_to(self.root)) for path in self.root.rglob("*") if not path.is_dir() or path.is_symlink())

    def test_what_it_needs_is_told(self):
        fields = dict(re.findall(r"^([A-Za-z-]+): (.*)$", (self.control / "control").read_text(), re.M))
        self.assertEqual(fields["Package"], "npsee")
        depends = re.findall(r"[a-z0-9.+-]+(?= \(|,|$)", fields["Depends"])
        for package in ("libc6", "libstdc++6", "libpng16-16", "libglfw3", "libosmesa6"):
            self.assertIn(package, depends)
        # Every library that the two binaries name comes from a package that is named.
        needed = set()
        for binary in ("usr/bin/npsee", *(name for name in self.listed() if re.search(r"libnpsee\.so\.[0-9.]+$", name))):
            needed |= set(re.findall(r"NEEDED.*\[(.*)\]", run("readelf", "-d", self.root / binary)))
        for library in needed:
            # Merged /usr: the package may list the library below /lib or /usr/lib.
            owners = {line.split(":")[0] for line in run("dpkg", "-S", "*/" + library).splitlines() if not line.startswith("diversion")}
            self.assertTrue(owners & set(depends), f"{library} is of {owners}, and only {depends} are named")

    def test_it_can_be_taken_away_again(self):
        for script in self.control.iterdir():
            if script.name in ("control", "md5sums", "shlibs", "triggers"):
                continue
            # The list of libraries is renewed and nothing else is done: what is listed is all there is.
            does = {line.strip() for line in script.read_text().splitlines()} - {"", "#!/bin/sh", "set -e", "fi"}
            self.assertTrue(all(line == "ldconfig" or re.fullmatch(r'if \[ "\$1" = "(configure|remove)" \]; then', line) for line in does), f"{script.name}: {does}")
        for name in self.listed():
            self.assertTrue(name.startswith("usr/"), name)
            self.assertNotRegex(name, r"^usr/local|__pycache__")
        before = self.listed()
        self.npsee("edit", self.root / "usr/share/npsee/presets/cascade.npsee.json", "--headless", "--screenshot", "editor.png")
        self.assertEqual(self.listed(), before, "running it leaves nothing among its files")

    def test_what_people_look_for_is_there(self):
        listed = set(self.listed())
        for name in ("usr/bin/npsee", "usr/include/npsee/c.h", "usr/share/npsee/presets/classic_1993.npsee.json", "usr/share/npsee/assets/missions/thesis_default.mission.json", "usr/share/applications/npsee.desktop",
                     "usr/share/mime/packages/npsee.xml", "usr/share/icons/hicolor/48x48/apps/npsee.png", "usr/share/man/man1/npsee.1", "usr/share/man/man1/npsee-render.1", "usr/share/bash-completion/completions/npsee"):
            self.assertTrue(name in listed or name + ".gz" in listed, name)
        self.assertTrue(any(re.search(r"libnpsee\.so\.1$", name) for name in listed))

    def test_editor_render_and_mission_work_where_it_is_unpacked(self):
        share = self.root / "usr/share/npsee"
        self.npsee("render", share / "presets/cascade.npsee.json", "--time", "1", "--size", "320x200", "-o", "picture.png")
        self.npsee("render", "cascade", "--time", "1", "--size", "320x200", "-o", "by_name.png")
        self.assertEqual((self.work / "picture.png").read_bytes(), (self.work / "by_name.png").read_bytes())
        self.assertGreater((self.work / "picture.png").stat().st_size, 5000)
        log = self.npsee("mission", share / "assets/missions/hills_patrol.mission.json", "--until", "30", "--record", "run.rec")
        self.assertIn('"ev":"end"', log)
        self.npsee("replay", "run.rec", "--render", "t=20", "-o", "mission.png")
        # The library of the editor lists what lies beside the program.
        self.npsee("edit", "--headless", "--screenshot", "editor.png", "--size", "1280x760")
        missing = self.work / "empty"
        missing.mkdir()
        self.npsee("edit", "--headless", "--screenshot", "without.png", "--size", "1280x760", "--library", missing)
        self.assertNotEqual((self.work / "editor.png").read_bytes(), (self.work / "without.png").read_bytes(), "the shipped presets are shown")

    def test_desktop_entry_and_file_types_are_valid(self):
        if shutil.which("desktop-file-validate") is None:
            self.skipTest("desktop-file-validate is not installed (scripts/packages.txt)")
        entry = self.root / "usr/share/applications/npsee.desktop"
        self.assertEqual(run("desktop-file-validate", entry), "")
        types = re.findall(r'<mime-type type="(.*)">', (self.root / "usr/share/mime/packages/npsee.xml").read_text())
        self.assertEqual(len(types), 2)
        for kind in types:
            self.assertIn(kind + ";", entry.read_text())
        if shutil.which("update-mime-database") is not None:
            mime = self.work / "mime"
            shutil.copytree(self.root / "usr/share/mime", mime)
            run("update-mime-database", mime)
            self.assertIn("*.mission.json", (mime / "globs").read_text())

    @unittest.skipIf(os.environ.get("SANITIZED") == "1", "sanitizers want to be the first library that is loaded")
    def test_the_library_in_it_can_be_called(self):
        (library,) = (name for name in self.listed() if re.search(r"libnpsee\.so\.1$", name))
        rows = run("python3", SOURCE / "tests/consumer/particles.py", self.root / library, self.root / "usr/share/npsee/presets/classic_1993.npsee.json", "0.5").splitlines()
        self.assertEqual(len(rows), 100)


class Uninstall(unittest.TestCase):
    """`cmake --build BUILD --target uninstall` runs this script over the places that installing has noted; here over one, for others may be real."""

    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def uninstall(self, place):
        return run(CMAKE, f"-DINSTALLED={BUILD / 'installed'}", f"-DPLACE={place}", "-P", SOURCE / "cmake/uninstall/uninstall.cmake")

    def everything(self, place):
        return sorted(str(path.relative_to(place)) for path in place.rglob("*"))

    def test_the_target_runs_the_script(self):
        commands = run("ninja", "-C", BUILD, "-t", "commands", "uninstall")
        self.assertIn(str(SOURCE / "cmake/uninstall/uninstall.cmake"), commands)
        self.assertIn(str(BUILD / "installed"), commands)

    def test_a_place_of_its_own_is_gone(self):
        place = self.folder / "opt/npsee"
        run(CMAKE, "--install", BUILD, "--prefix", place)
        self.assertTrue((place / "bin/npsee").exists())
        self.assertGreater(len(self.everything(place)), 100)
        # Once more over it, in parts: what was made by the first time is still ours.
        for component in ("library", "development"):
            run(CMAKE, "--install", BUILD, "--prefix", place, "--component", component)
        self.uninstall(place)
        self.assertEqual(self.everything(self.folder), ["opt"])

    def test_what_others_have_there_stays(self):
        place = self.folder / "shared place"
        others = ("bin/other", "share/npsee/presets/mine.npsee.json", "include/other.h", "share/man/man1/other.1")
        for name in others:
            (place / name).parent.mkdir(parents=True, exist_ok=True)
            (place / name).write_text("of others")
        for name in ("lib", "share/applications", "share/icons/hicolor/48x48/apps"):
            (place / name).mkdir(parents=True, exist_ok=True)
        before = self.everything(place)
        run(CMAKE, "--install", BUILD, "--prefix", place)
        (place / "bin/npsee").unlink()
        told = self.uninstall(place)
        self.assertIn("is gone already", told)
        self.assertEqual(self.everything(place), before)
        self.assertTrue(all((place / name).read_text() == "of others" for name in others))

    def test_packing_is_no_installing(self):
        noted = set((BUILD / "installed").glob("*"))
        with tempfile.TemporaryDirectory() as kept:
            run(pathlib.Path(CMAKE).with_name("cpack"), "--config", BUILD / "CPackConfig.cmake", "-B", kept, "-G", "TGZ", cwd=kept)
        self.assertLessEqual(set((BUILD / "installed").glob("*")), noted)


class SourceArchive(unittest.TestCase):
    def test_it_is_whole_and_can_be_configured_without_network(self):
        with tempfile.TemporaryDirectory() as kept:
            folder = pathlib.Path(kept)
            cpack("CPackSourceConfig.cmake", folder)
            (archive,) = folder.glob("*.tar.xz")
            run("tar", "-xf", archive, "-C", folder)
            (tree,) = (path for path in folder.iterdir() if path.is_dir() and not path.name.startswith("_"))
            held = {str(path.relative_to(tree)) for path in tree.rglob("*") if not path.is_dir()}
            self.assertFalse([name for name in held if name.startswith((".git/", "build/", "out/"))])
            if (SOURCE / ".git").exists() and shutil.which("git") is not None:
                tracked = set(run("git", "-c", f"safe.directory={SOURCE}", "-C", SOURCE, "ls-files").splitlines())
                self.assertEqual({name for name in tracked if (SOURCE / name).exists()} - held, set(), "every file of the project is in the archive")
            # The way out is closed to whatever would fetch something.
            closed = {**os.environ, "http_proxy": "http://127.0.0.1:9", "https_proxy": "http://127.0.0.1:9", "GIT_ALLOW_PROTOCOL": "file"}
            run(CMAKE, "-S", tree, "-B", folder / "b", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", env=closed)
            # The loader, whose source is generated, is compiled for real; every other room takes what stands in the same archive.
            run("ninja", "-C", folder / "b", "npsee_glad", env=closed)
            cache = (folder / "b/CMakeCache.txt").read_text()
            self.assertNotIn("FETCHCONTENT", cache)


if __name__ == "__main__":
    unittest.main()
