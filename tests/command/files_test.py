"""Files and standard streams that fail, and files that must be whole or not there."""

import os
import pty
import resource
import signal
import stat
import subprocess
import time
import unittest

from support import CLIP, COMMAND, HEADER, CommandTest, main, run


def listing(folder):
    return sorted(os.listdir(folder))


def drained(terminal):
    """What is left to read on a terminal that nobody holds any more."""
    seen = b""
    while True:
        try:
            part = os.read(terminal, 4096)
        except OSError:
            return seen
        if not part:
            return seen
        seen += part


class Files(CommandTest):
    def setUp(self):
        super().setUp()
        self.table = self.path("in.csv", HEADER + "0 0 1 0\n")
        self.expected = run("eval", "twist", self.table).stdout

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def test_results_replace_a_file_as_a_whole(self):
        out = self.path("out.csv", "old")
        os.chmod(out, 0o640)
        result = self.succeeds("eval", "twist", self.table, "--out", out)
        self.assertEqual(result.stdout, b"")
        self.assertEqual(self.content("out.csv"), self.expected)
        self.assertEqual(stat.S_IMODE(os.stat(out).st_mode), 0o640)
        self.assertEqual(listing(self.folder), ["in.csv", "out.csv"])

    def test_a_new_file_has_the_usual_mode(self):
        mask = os.umask(0o027)
        try:
            self.succeeds("eval", "twist", self.table, "--out", self.path("new.csv"))
        finally:
            os.umask(mask)
        self.assertEqual(stat.S_IMODE(os.stat(self.path("new.csv")).st_mode), 0o640)

    def test_the_output_may_be_the_input(self):
        self.succeeds("eval", "twist", self.table, "--out", self.table)
        self.assertEqual(self.content("in.csv"), self.expected)

    def test_a_link_stays_one(self):
        self.path("target.csv", "old")
        os.symlink("target.csv", self.path("link.csv"))
        self.succeeds("eval", "twist", self.table, "--out", self.path("link.csv"))
        self.assertTrue(os.path.islink(self.path("link.csv")))
        self.assertEqual(self.content("target.csv"), self.expected)
        os.symlink("nowhere.csv", self.path("dangling.csv"))
        self.succeeds("eval", "twist", self.table, "--out", self.path("dangling.csv"))
        self.assertEqual(self.content("nowhere.csv"), self.expected)

    def test_bad_data_leaves_the_output_alone(self):
        out = self.path("out.csv", "old")
        bad = self.path("bad.csv", HEADER + "0 0 1 0\n" * 70000 + "0 0 1 x\n")
        result = self.fails(1, bad + ":70002:7: 'x' is not a number", "eval", "twist", bad, "--out", out)
        self.assertEqual(result.stdout, b"")
        self.assertEqual(self.content("out.csv"), b"old")
        self.assertEqual(listing(self.folder), ["bad.csv", "in.csv", "out.csv"])

    def test_files_that_cannot_be_read_or_written_are_named(self):
        missing, folder = self.path("missing"), self.folder
        clip = self.path("clip.bvh", CLIP)
        for message, arguments in (
            (missing + ": cannot open the file: No such file or directory", ["eval", "twist", missing]),
            (folder + ": cannot read the file: Is a directory", ["eval", "twist", folder]),
            (missing + ": cannot open the file: No such file or directory", ["decompose", missing]),
            (folder + ": cannot read the file: Is a directory", ["decompose", folder]),
            (folder + ": cannot write the file: Is a directory", ["eval", "twist", self.table, "--out", folder]),
            (folder + ": cannot write the file: Is a directory", ["decompose", clip, "--out", folder]),
            (missing + "/x.csv: cannot create a temporary file in the same folder: No such file or directory",
             ["decompose", clip, "--out", missing + "/x.csv"]),
            ("the name of the output file is empty", ["eval", "twist", self.table, "--out", ""]),
            ("the name of the output file is empty", ["decompose", clip, "--out", ""]),
        ):
            result = self.fails(1, message, *arguments)
            self.assertEqual(result.stdout, b"", arguments)
        self.assertEqual(listing(self.folder), ["clip.bvh", "in.csv"])

    def test_a_full_disk_is_an_error(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        clip = self.path("clip.bvh", CLIP)
        for arguments in (["eval", "twist", self.table], ["decompose", clip], ["decompose", clip, "--out", "-"],
                          ["info"], ["--help"], ["--version"], ["eval", "twist", "--help"]):
            with open("/dev/full", "wb") as full:
                result = subprocess.run(COMMAND + arguments, stdout=full, stderr=subprocess.PIPE, check=False)
            self.assertEqual(result.returncode, 1, arguments)
            self.assertIn("<stdout>: cannot write the file: No space left on device", result.stderr.decode())
        for command in (["eval", "twist", self.table], ["decompose", clip]):
            self.fails(1, "/dev/full: cannot write the file: No space left on device", *command, "--out", "/dev/full")
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/full").st_mode))

    def test_devices_are_written_to(self):
        self.succeeds("eval", "twist", self.table, "--out", "/dev/null")
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_a_closed_standard_output_is_an_error(self):
        clip = self.path("clip.bvh", CLIP)
        for command in ('"$@" eval twist "$0"', '"$@" info', '"$@" --version'):
            result = subprocess.run(["sh", "-c", command + " >&-", self.table, *COMMAND], stderr=subprocess.PIPE,
                                    stdout=subprocess.PIPE, check=False)
            self.assertEqual(result.returncode, 1, (command, result.stderr))
        result = subprocess.run(["sh", "-c", '"$@" decompose "$0" --out "$0.csv" >&-', clip, *COMMAND],
                                stderr=subprocess.PIPE, check=False)
        self.assertEqual(result.returncode, 1)
        self.assertNotIn(b"twist min", self.content("clip.bvh.csv"))

    def test_a_closed_pipe_ends_the_command_quietly(self):
        table = self.path("long.csv", HEADER + "0 0 1 0\n" * 300000)
        with subprocess.Popen(COMMAND + ["eval", "twist", table], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as process:
            self.assertEqual(process.stdout.readline(), b"tx,ty,tz,tw\n")
            process.stdout.close()
            self.assertEqual(process.stderr.read(), b"")
            self.assertEqual(process.wait(), 1)

    def test_an_interrupted_command_leaves_nothing(self):
        out = self.path("out.csv", "old")
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGABRT,
                       signal.SIGALRM, signal.SIGUSR1, signal.SIGUSR2, signal.SIGXCPU):
            with subprocess.Popen(COMMAND + ["eval", "twist", "--out", out], stdin=subprocess.PIPE) as process:
                process.stdin.write((HEADER + "0 0 1 0\n" * 200000).encode())
                process.stdin.flush()
                for _ in range(500):
                    if len(listing(self.folder)) == 3:
                        break
                    time.sleep(0.01)
                self.assertEqual(len(listing(self.folder)), 3)
                self.assertRegex(listing(self.folder)[0], r"^\.out\.csv\.swivel-")
                process.send_signal(number)
                process.wait()
                self.assertNotEqual(process.returncode, 0)
            self.assertEqual(listing(self.folder), ["in.csv", "out.csv"])
            self.assertEqual(self.content("out.csv"), b"old")

    def test_a_file_that_grows_too_large_is_an_error(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
        result = subprocess.run(COMMAND + ["eval", "twist", "--out", self.path("large.csv")],
                                input=(HEADER + "0 0 1 0\n" * 20000).encode(), capture_output=True,
                                preexec_fn=limit, timeout=300)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"large.csv: cannot write the file: File too large", result.stderr)
        self.assertEqual(listing(self.folder), ["in.csv"])

    def test_a_clip_is_not_replaced_by_its_table(self):
        clip = self.path("walk.bvh", CLIP)
        os.link(clip, self.path("hard.bvh"))
        os.symlink("walk.bvh", self.path("soft.bvh"))
        for name in ("walk.bvh", "./walk.bvh", "hard.bvh", "soft.bvh"):
            out = os.path.join(self.folder, name)
            self.fails(2, "--out: " + out + " is the file that is read", "decompose", clip, "--out", out)
        result = subprocess.run(COMMAND + ["decompose", "-", "--out", clip], stdin=open(clip, "rb"),
                                capture_output=True, timeout=300)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(self.content("walk.bvh"), CLIP.encode())

    @unittest.skipUnless(os.geteuid() == 0, "only root gives files away")
    def test_the_owner_of_a_file_keeps_it(self):
        out = self.path("out.csv", "old")
        os.chown(out, 65534, 65534)
        os.chmod(out, 0o640)
        self.succeeds("eval", "twist", self.table, "--out", out)
        about = os.stat(out)
        self.assertEqual((about.st_uid, about.st_gid, stat.S_IMODE(about.st_mode)), (65534, 65534, 0o640))

    def test_a_terminal_sees_progress_and_nobody_else(self):
        for seconds, terminal in ((0, True), (1.5, True), (1.5, False)):
            parent, child = pty.openpty()
            with subprocess.Popen(COMMAND + ["eval", "twist"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                  stderr=child if terminal else subprocess.PIPE) as process:
                os.close(child)
                time.sleep(seconds)
                out, error = process.communicate((HEADER + "0 0 1 0\n").encode())
            seen = drained(parent) if terminal else error
            os.close(parent)
            self.assertEqual(out, self.expected)
            if terminal and seconds > 0:
                self.assertIn(b"reading <stdin> 1 s", seen)
                self.assertTrue(seen.endswith(b"\r\033[K"), seen)
            else:
                self.assertEqual(seen, b"")

    def test_the_locale_does_not_matter(self):
        for locale in ("de_DE.UTF-8", "C.UTF-8", "C", "tr_TR.UTF-8"):
            result = self.succeeds("eval", "twist_angle", "--precision", "reproducible", stdin=HEADER + "0 0 .5 0\n",
                                   environment={"LC_ALL": locale})
            self.assertEqual(result.stdout, b"angle\n3.141592653589793\n")


if __name__ == "__main__":
    main()
