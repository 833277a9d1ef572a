"""A run stopped in any way and started again ends in the same bytes as one never stopped."""

import random
import shutil
import signal
import subprocess
import time
import unittest

from program import PROGRAM, STUDY, Case

SLOW = STUDY.replace("speed = 2e-3", "speed = 2e-4")  # a second or two a run, so that a stop falls inside


class Resume(Case):
    def setUp(self):
        super().setUp()
        self.write("slow.toml", SLOW)

    def whole(self):
        self.program("run", "slow.toml", "--out", "whole", "--quiet")

    def test_killed_again_and_again(self):
        self.whole()
        rng = random.Random(1)
        kills = 0
        for wanted in (1, 2, 4, 6, 3):
            process = self.start("run", "slow.toml", "--out", "out", "--checkpoint", "0.02", "--jobs", "2", "--quiet")
            self.wait_for(process, lambda: self.frames("out") >= wanted and self.checkpoints("out") > 0)
            time.sleep(0.05 * rng.random())
            kills += process.poll() is None
            process.kill()
            process.communicate()
        self.assertGreater(kills, 0, "every run ended before it was killed")
        self.program("run", "slow.toml", "--out", "out", "--quiet")
        self.assert_same_results("whole", "out")
        self.assertEqual(self.frames("out") + self.checkpoints("out"), 0, "nothing is left over")

    def test_signals_save_and_say_so(self):
        """Whatever a person, a scheduler or a lost terminal sends, once or again and again."""
        one = ("--set", "study.realisations=1", "--only", "rough")
        self.program("run", "slow.toml", "--out", "whole", "--quiet", *one)
        for name in ("INT", "TERM", "HUP", "USR1", "USR2", "XCPU", "PIPE", "ALRM"):
            sign = getattr(signal, "SIG" + name)
            process = self.start("run", "slow.toml", "--out", name, "--jobs", "1", *one)
            self.wait_for(process, lambda: self.frames(name) >= 2)
            for _ in range(3):
                process.send_signal(sign)
            output = process.communicate(timeout=60)[0]
            self.assertEqual(process.returncode, 5, f"{name}: {output}")
            self.assertIn("goes on where it stopped", output)
            self.assertGreater(self.checkpoints(name), 0, name)
            self.program("run", "slow.toml", "--out", name, "--quiet", *one)
            self.assert_same_results("whole", name)

    def test_nohup(self):
        one = ("--set", "study.realisations=1", "--only", "rough", "--quiet")
        process = subprocess.Popen(["nohup", PROGRAM, "run", "slow.toml", "--out", "out", *one], cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.wait_for(process, lambda: self.frames("out") >= 2)
        process.send_signal(signal.SIGHUP)
        self.assertEqual(process.wait(timeout=120), 0)

    def test_a_reader_who_goes_away_stops_it_as_a_signal_does(self):
        process = self.start("run", "slow.toml", "--out", "out", "--jobs", "1", "--json")
        self.wait_for(process, lambda: self.frames("out") >= 1)
        process.stdout.close()
        self.assertEqual(process.wait(timeout=120), 5)
        self.program("run", "slow.toml", "--out", "out", "--quiet")
        self.whole()
        self.assert_same_results("whole", "out")

    def test_stopped_in_the_middle_of_a_stage_it_does_not_begin_again(self):
        self.write("slow.toml", STUDY.replace("speed = 2e-3", "speed = 3e-5"))  # stops are heard every quarter of a second
        process = self.start("run", "slow.toml", "--out", "out", "--jobs", "1", "--quiet")
        self.wait_for(process, lambda: self.frames("out") >= 3)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        log = "".join(p.read_text() for p in (self.folder / "out").glob("tasks/*/log.jsonl"))
        self.assertNotIn("resumed", log)
        self.program("run", "slow.toml", "--out", "out", "--quiet")
        log = "".join(p.read_text() for p in (self.folder / "out").glob("tasks/*/log.jsonl"))
        self.assertIn("resumed", log)

    def test_damaged_or_lost_files_are_made_again(self):
        self.whole()
        process = self.start("run", "slow.toml", "--out", "out", "--checkpoint", "0.02", "--quiet")
        self.wait_for(process, lambda: self.checkpoints("out") > 0 and self.frames("out") > 2)
        process.kill()
        process.communicate()
        for checkpoint in (self.folder / "out").glob("tasks/*/checkpoint.h5"):
            data = checkpoint.read_bytes()
            checkpoint.write_bytes(data[: len(data) // 2])
        self.program("run", "slow.toml", "--out", "out", "--quiet")
        self.assert_same_results("whole", "out")
        next((self.folder / "out").glob("tasks/*/tables/coordination.csv")).unlink()
        self.program("run", "slow.toml", "--out", "out", "--quiet")
        self.assert_same_results("whole", "out")

    def test_full_disk(self):
        """A limit on the size of files stands for a full disk: the write fails in the middle."""
        self.whole()
        limited = subprocess.run(["bash", "-c", f'trap "" XFSZ; ulimit -f 8; exec "{PROGRAM}" run slow.toml --out out --quiet'],
                                 cwd=self.folder, capture_output=True, text=True, timeout=600)
        self.assertIn(limited.returncode, (3, 6), limited.stderr)
        self.assertIn("File too large", limited.stderr, "the reason is said, though nothing else is")
        self.assertNotIn("HDF5:", limited.stderr)
        self.assertFalse(list((self.folder / "out").glob("tasks/*/run.h5")))
        self.program("run", "slow.toml", "--out", "out", "--quiet")
        self.assert_same_results("whole", "out")

    def test_two_runners_in_one_folder(self):
        process = self.start("run", "slow.toml", "--out", "out", "--quiet")
        self.wait_for(process, lambda: self.frames("out") >= 1)
        if process.poll() is None:
            error = self.program("run", "slow.toml", "--out", "out", code=2).stderr
            self.assertIn(str(process.pid), error)
            self.assertIn("--shard", error)
        process.communicate()
        self.assertEqual(process.returncode, 0)

    def test_killed_while_tables_are_written(self):
        self.whole()
        shutil.copytree(self.folder / "whole", self.folder / "out")
        for part in ("tables", "ensemble"):
            for file in (self.folder / "out" / part).iterdir():
                file.unlink()
        (self.folder / "out/tables/frames.csv.part").write_text("half a li")
        self.program("run", "slow.toml", "--out", "out", "--quiet")
        self.assertFalse((self.folder / "out/tables/frames.csv.part").exists())
        self.assert_same_results("whole", "out")


if __name__ == "__main__":
    unittest.main()
