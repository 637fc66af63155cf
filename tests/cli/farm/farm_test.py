#!/usr/bin/env python3
"""`pomona farm` on a machine without a farm: its scripts and commands run by a shell, with any names of paths; the arguments for
Slurm; the status against the folder and a queue. tests/programs/slurm_farm.py has a real Slurm.

    farm_test.py PROGRAM SOURCE [unittest's words]
"""

import fcntl
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

import yaml

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "batch"))
from batches import SMALL, pomona, tree  # noqa: E402

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()

# All characters with a meaning in shells, printf, Slurm's file names or JSON.
HOSTILE = "it's 100%j \"$HOME\" `id` $(id) \\n & ; | > < * ? ~ # {a,b} ünï"
LINE_BREAK = "two\nlines\n#SBATCH --array=0-9\n'"


class Sandbox(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="pomona-test-")
        self.path = pathlib.Path(self.folder.name).resolve() / "here"
        self.tools = pathlib.Path(self.folder.name).resolve() / "tools"
        for each in (self.path, self.tools):
            each.mkdir()
        (self.path / "small.toml").write_text(SMALL)

    def tearDown(self):
        self.folder.cleanup()

    def tool(self, name, script):
        """A program that comes before all others of its name in PATH."""
        file = self.tools / name
        file.write_text("#!/bin/sh\n" + script)
        file.chmod(0o755)
        return file

    def environment(self, **more):
        return dict(os.environ, PATH=f"{self.tools}:{os.environ['PATH']}", **more)

    def farm(self, *words, status=0, folder=None):
        result = subprocess.run([PROGRAM, "farm", *map(str, words)], cwd=folder or self.path, env=self.environment(),
                                text=True, capture_output=True)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result

    def shell(self, *words, status=0, **environment):
        result = subprocess.run(["sh", *map(str, words)], cwd="/", env=self.environment(**environment), text=True,
                                capture_output=True)
        self.assertEqual(result.returncode, status, result.stderr)
        return result

    def alone(self):
        """The tree of a single run."""
        result = pomona(PROGRAM, "batch", "small.toml", "-o", "alone", "--quiet", folder=self.path)
        self.assertEqual(result.returncode, 0, result.stderr)
        return tree(self.path / "alone")


class Scripts(Sandbox):
    def test_make_and_merge_a_batch_wherever_it_lies(self):
        expected = self.alone()
        for name in (HOSTILE, LINE_BREAK):
            folder = self.path / name
            folder.mkdir()
            (folder / "small.toml").write_text(SMALL)
            self.farm("slurm", "small.toml", "-o", "-out", "--tasks", 2, "--dry-run", folder=folder)
            scripts = folder / "-out.farm"
            for task in (2, 1):
                self.shell(scripts / "shard.sh", SLURM_ARRAY_TASK_ID=str(task))
            self.assertFalse((folder / "-out" / "manifest.json").exists())
            self.shell(scripts / "merge.sh")
            self.assertEqual(tree(folder / "-out"), expected)
            self.assertIn("made", (scripts / "logs" / "shard-1.txt").read_text())

    def test_say_nothing_that_slurm_takes_for_options(self):
        folder = self.path / LINE_BREAK
        folder.mkdir()
        (folder / "small.toml").write_text(SMALL)
        self.farm("slurm", "small.toml", "-o", "out", "--dry-run", folder=folder)
        for name in ("shard.sh", "merge.sh"):
            before_commands = (folder / "out.farm" / name).read_text().split("set -u")[0]
            self.assertNotIn("#SBATCH", before_commands)

    def test_use_the_threads_that_slurm_gives(self):
        self.tool("program", 'printf "%s\\n" "$@" >>"$SEEN"')
        self.farm("slurm", "small.toml", "-o", "out", "--dry-run", "--program", self.tools / "program", "--memory", "2GB")
        for given, used in ({"SLURM_CPUS_PER_TASK": "6"}, "6"), ({}, "1"):
            seen = self.path / f"seen-{used}"
            self.shell(self.path / "out.farm" / "shard.sh", SLURM_ARRAY_TASK_ID="7", SEEN=str(seen), **given)
            self.assertEqual(seen.read_text().splitlines(),
                             ["batch", str(self.path / "small.toml"), "-o", str(self.path / "out"), "--shard", "7/64",
                              "--resume", "--threads", used, "--memory", "2GB"])


# Replaces sbatch: records its arguments, and runs the script at once.
SBATCH = """
printf '%s\\0' "$@" >>"$0.words"; printf '\\n\\0' >>"$0.words"
for word; do
  case $word in --array=1-*) last=${word#--array=1-}; last=${last%%%*} ;; esac
done
if [ -n "${last-}" ]; then
  for i in $(seq "$last"); do SLURM_ARRAY_TASK_ID=$i sh "$word"; done
  echo "41;a_cluster"
else
  sh "$word"
  echo 42
fi
"""


class Submission(Sandbox):
    def words(self):
        """The arguments of each call of sbatch."""
        calls, words = [], []
        for word in (self.tools / "sbatch.words").read_bytes().split(b"\0")[:-1]:
            if word == b"\n":
                calls.append(words)
                words = []
            else:
                words.append(word.decode())
        return calls

    def check_calls(self, folder):
        array, merge = self.words()
        self.assertIn("--requeue", array)
        self.assertIn("--array=1-3%2", array)
        self.assertIn("--dependency=afterany:41", merge)
        for call, script in (array, "shard.sh"), (merge, "merge.sh"):
            self.assertIn("--comment=it's $HOME; `id`", call)
            self.assertEqual(call[-2:], ["--", str(folder / "out.farm" / script)])
        self.assertEqual((folder / "out.farm" / "jobs").read_text(), "array 41\nmerge 42\n")

    def test_by_pomona_and_by_hand_are_the_same(self):
        self.tool("sbatch", SBATCH)
        self.tool("squeue", "exit 1")
        expected = self.alone()
        words = ["slurm", "small.toml", "-o", "out", "--tasks", 3, "--at-once", 2, "--sbatch=--comment=it's $HOME; `id`"]
        for name, more in (HOSTILE, []), ("by hand", ["--dry-run"]):
            folder = self.path / name
            folder.mkdir()
            (folder / "small.toml").write_text(SMALL)
            out = self.farm(*words, *more, folder=folder).stdout
            if more:
                self.assertFalse((self.tools / "sbatch.words").exists())
                subprocess.run(out.replace(" submits them", ""), shell=True, check=True, env=self.environment())
            else:
                self.assertEqual(out, "job 41: 3 tasks; job 42 merges them\n")
            self.check_calls(folder)
            self.assertEqual(tree(folder / "out"), expected)
            (self.tools / "sbatch.words").unlink()

    def test_refused_is_told(self):
        self.tool("sbatch", "echo 'sbatch: error: no such partition' >&2; exit 1")
        result = self.farm("slurm", "small.toml", "-o", "out", status=69)
        self.assertIn("no such partition", result.stderr)
        self.assertIn("out.farm/submit.sh", result.stderr)
        self.assertTrue((self.path / "out.farm" / "submit.sh").exists())
        self.assertFalse((self.path / "out.farm" / "jobs").exists())

    def test_without_a_merge_is_told(self):
        self.tool("sbatch", 'case "$*" in *--array*) echo 41 ;; *) exit 1 ;; esac')
        result = self.farm("slurm", "small.toml", "-o", "out", status=69)
        self.assertIn("job 41 makes the shards, but no merge waits for it", result.stderr)
        self.assertEqual((self.path / "out.farm" / "jobs").read_text(), "array 41\n")

    def test_twice_is_refused_while_the_first_is_queued(self):
        self.tool("sbatch", "echo 41")
        self.tool("squeue", "echo '41_3|PENDING|Resources'")
        self.farm("slurm", "small.toml", "-o", "out")
        result = self.farm("slurm", "small.toml", "-o", "out", status=75)
        self.assertIn("in the queue already, as job 41", result.stderr)
        self.tool("squeue", "echo 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1")
        self.farm("slurm", "small.toml", "-o", "out")


class Retries(Sandbox):
    def attempts(self, statuses, retries=2):
        """The status of a task whose runs end with these, and its waiting times."""
        self.tool("program", f"""
n=$(cat "$0.n" 2>/dev/null || echo 0); echo $((n + 1)) >"$0.n"
set -- {" ".join(map(str, statuses))}; shift "$n"
[ "$1" -gt 128 ] && kill -$(($1 - 128)) $$
exit "$1"
""")
        self.tool("sleep", 'echo "$1" >>"$0.waits"')
        for left in ("program.n", "sleep.waits"):
            (self.tools / left).unlink(missing_ok=True)
        self.farm("slurm", "small.toml", "-o", "out", "--dry-run", "--program", self.tools / "program", "--retries", retries)
        result = subprocess.run(["sh", self.path / "out.farm" / "shard.sh"], env=self.environment(SLURM_ARRAY_TASK_ID="1"))
        waits = self.tools / "sleep.waits"
        return result.returncode, waits.read_text().split() if waits.exists() else []

    def test_are_for_what_may_pass(self):
        self.assertEqual(self.attempts([75, 0]), (0, ["10"]))
        self.assertEqual(self.attempts([137, 74, 0]), (0, ["10", "20"]))

    def test_end(self):
        self.assertEqual(self.attempts([74, 74, 74, 0]), (74, ["10", "20"]))
        self.assertEqual(self.attempts([75, 0], retries=0), (75, []))

    def test_are_not_for_what_stays(self):
        for status in (1, 64, 65, 66, 69, 70, 73):
            self.assertEqual(self.attempts([status, 0]), (status, []))


class Commands(Sandbox):
    def test_make_the_batch_in_any_order(self):
        folder = self.path / HOSTILE
        folder.mkdir()
        (folder / "small.toml").write_text(SMALL)
        lines = self.farm("commands", "small.toml", "-o", "out", "--tasks", 3, folder=folder).stdout.splitlines()
        self.assertEqual(len(lines), 3)
        for line in reversed(lines):
            self.shell("-c", line)
        self.assertEqual(pomona(PROGRAM, "merge", folder / "out").returncode, 0)
        self.assertEqual(tree(folder / "out"), self.alone())

    def test_take_the_threads_that_opencue_gives(self):
        lines = self.farm("commands", "small.toml", "-o", "out", "--opencue", "--tasks", 2).stdout.splitlines()
        self.assertTrue(all(line.endswith(' --threads "${CUE_THREADS:-1}"') for line in lines), lines)
        self.shell("-c", lines[0], CUE_THREADS="2")

    def test_stand_on_a_line_each(self):
        result = self.farm("commands", "small.toml", "-o", LINE_BREAK, status=64)
        self.assertIn("line break", result.stderr)
        self.assertEqual(result.stdout, "")


class Status(Sandbox):
    def shards(self, *words, status=1):
        answer = json.loads(self.farm("status", "out", "--json", *words, status=status).stdout)
        return answer, [(shard["state"], shard["done"], shard["failed"], shard["missing"]) for shard in answer["shards"]]

    def make(self, shard):
        result = pomona(PROGRAM, "batch", "small.toml", "-o", "out", "--shard", shard, "--resume", folder=self.path)
        self.assertEqual(result.returncode, 0, result.stderr)

    def items(self):
        return len(list((self.path / "out").rglob("item.json")))

    def test_counts_what_each_shard_has_made(self):
        # Five individuals in shards of two, two and one, four of them cut in two ways: nine items.
        self.make("2/3")
        answer, shards = self.shards("--tasks", 3)
        self.assertEqual(shards[1][:2], ("done", self.items()))
        self.assertEqual([shard[:2] for shard in (shards[0], shards[2])], [("missing", 0)] * 2)
        self.assertEqual((answer["items"], answer["done"], answer["merge"]), (9, self.items(), "missing"))
        for shard in ("1/3", "3/3"):
            self.make(shard)
        answer, shards = self.shards("--tasks", 3)
        self.assertEqual([shard[0] for shard in shards], ["done"] * 3)
        self.assertEqual(sum(shard[1] for shard in shards), 9)
        self.assertFalse(answer["complete"])
        self.assertEqual(pomona(PROGRAM, "merge", self.path / "out").returncode, 0)
        self.assertTrue(self.shards("--tasks", 3, status=0)[0]["complete"])

    def test_tells_runs_at_work_from_those_that_were_killed(self):
        self.make("2/3")
        hidden = self.path / "out" / ".pomona"
        hidden.mkdir(exist_ok=True)
        lock = open(hidden / "1-of-3.lock", "w")
        self.assertEqual(self.shards("--tasks", 3)[1][0][0], "stopped")
        fcntl.flock(lock, fcntl.LOCK_EX)
        self.assertEqual(self.shards("--tasks", 3)[1][0][0], "running")
        lock.close()

    def test_counts_items_that_failed(self):
        self.make("1/1")
        item = next((self.path / "out").rglob("item.json"))
        record = json.loads(item.read_text())
        record["error"] = "it did not work out"
        item.write_text(json.dumps(record) + "\n")
        self.assertEqual(self.shards()[1], [("failed", 8, 1, 0)])

    def test_is_told_as_a_table(self):
        self.make("2/3")
        lines = self.farm("status", "out", "--tasks", 3, status=1).stdout.splitlines()
        self.assertEqual(lines[0].split(), ["shard", "state", "done", "failed", "missing", "slurm"])
        self.assertEqual(lines[2].split()[:2], ["2", "done"])
        self.assertEqual(lines[4].split()[0], "all")
        self.assertEqual(lines[5], "merge: missing")


class Queue(Sandbox):
    def status(self):
        result = self.farm("status", "out", "--json", status=1)
        return json.loads(result.stdout), result.stderr

    def submit(self):
        self.tool("sbatch", 'case "$*" in *--array*) echo 41 ;; *) echo 42 ;; esac')
        self.tool("squeue", "exit 1")
        self.farm("slurm", "small.toml", "-o", "out", "--tasks", 4)

    def test_is_read_beside_the_folder(self):
        self.submit()
        self.tool("squeue", """[ "$3" = --jobs=41,42 ] || exit 9
printf '41_1|RUNNING|None\\n41_2|PENDING|Resources\\n410_4|RUNNING|None\\n42|PENDING|Dependency\\n'""")
        self.tool("sacct", "printf '41_1|NODE_FAIL\\n41_3|OUT_OF_MEMORY\\n41_[4]|PENDING\\n'")
        answer, _ = self.status()
        self.assertEqual([(shard["state"], shard["slurm"], shard["reason"]) for shard in answer["shards"]],
                         [("running", "RUNNING", ""), ("waiting", "PENDING", "Resources"), ("missing", "OUT_OF_MEMORY", ""),
                          ("missing", "", "")])
        self.assertEqual((answer["merge"], answer["jobs"]), ("waiting", {"array": "41", "merge": "42"}))

    def test_that_has_forgotten_the_job_is_an_answer(self):
        self.submit()
        self.tool("squeue", "echo 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1")
        answer, told = self.status()
        self.assertNotIn("trouble", answer)
        self.assertEqual(told, "")

    def test_that_does_not_answer_is_told(self):
        self.submit()
        self.tool("squeue", "echo 'cannot contact the controller' >&2; exit 1")
        answer, told = self.status()
        self.assertEqual(answer["trouble"], "cannot contact the controller")
        self.assertIn("cannot contact the controller", told)


class BadInput(Sandbox):
    def check_refused(self, words, status, says):
        before = tree(self.path)
        self.assertIn(says, self.farm(*words, status=status).stderr)
        self.assertEqual(tree(self.path), before)

    def test_is_told_before_anything_is_written(self):
        slurm = ["slurm", "small.toml", "-o", "out"]
        for option in ("--array=1-3", "--arr=1-3", "--wrap=id", "--wait", "--output=x", "--dep=1", "--parsable"):
            self.check_refused([*slurm, f"--sbatch={option}"], 64, "pomona itself says")
        for option in ("-p", "main", "--", "--=x"):
            self.check_refused([*slurm, f"--sbatch={option}"], 64, "no long option")
        self.check_refused([*slurm, "--memory", "much"], 64, "no size")
        self.check_refused([*slurm, "--tasks", 0], 64, "--tasks")
        self.check_refused(["slurm", "absent.toml", "-o", "out"], 66, "absent.toml")
        (self.path / "wrong.toml").write_text(SMALL.replace("count", "cuont"))
        self.check_refused(["slurm", "wrong.toml", "-o", "out"], 65, "wrong.toml:13")
        self.check_refused(["status", "out"], 66, "holds no batch")

    def test_is_another_batchs_folder(self):
        self.assertEqual(pomona(PROGRAM, "batch", "small.toml", "-o", "out", "--quiet", folder=self.path).returncode, 0)
        (self.path / "other.toml").write_text(SMALL.replace("seed = 5", "seed = 6"))
        self.check_refused(["slurm", "other.toml", "-o", "out"], 73, "another seed")

    def test_is_a_record_that_is_none(self):
        (self.path / "out.farm").mkdir()
        for record in ("", "{}", '{"tasks":0}', '{"tasks":1e9}', '{"tasks":"4"}', '{"tasks":1.5}'):
            (self.path / "out.farm" / "farm.json").write_text(record)
            self.farm("status", "out", status=65)
        (self.path / "out.farm" / "farm.json").write_text('{"tasks":4}')
        (self.path / "out.farm" / "jobs").write_text("array 41,42;id\n")
        self.farm("status", "out", status=65)


class Files(Sandbox):
    """docs/guides/farm: what they say is done, with their places filled in."""

    def read(self, name):
        return yaml.safe_load((SOURCE / "docs" / "guides" / "farm" / name).read_text())

    def merged(self, out):
        self.assertEqual(tree(out), self.alone())

    def test_of_open_job_description(self):
        template = self.read("openjd.yaml")
        self.assertEqual(template["specificationVersion"], "jobtemplate-2023-09")
        given = {"BatchFile": self.path / "small.toml", "Output": self.path / "out", "Shards": 2, "Program": PROGRAM}
        values = {f"Param.{each['name']}": given.get(each["name"], each.get("default"))
                  for each in template["parameterDefinitions"]}
        filled = lambda text: re.sub(r"\{\{(.*?)\}\}", lambda place: str(values[place[1].strip()]), str(text))
        shards, merge = template["steps"]
        self.assertEqual(merge["dependencies"], [{"dependsOn": shards["name"]}])
        (task,) = shards["parameterSpace"]["taskParameterDefinitions"]
        first, last = map(int, filled(task["range"]).split("-"))
        for shard in range(first, last + 1):
            values[f"Task.Param.{task['name']}"] = shard
            self.run_action(shards, filled)
        self.run_action(merge, filled)
        self.merged(self.path / "out")

    def run_action(self, step, filled):
        action = step["script"]["actions"]["onRun"]
        result = subprocess.run([filled(action["command"]), *map(filled, action["args"])], text=True, capture_output=True)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_of_kubernetes(self):
        shards, merge = self.read("kubernetes_shards.yaml"), self.read("kubernetes_merge.yaml")
        self.assertEqual((shards["kind"], shards["spec"]["completionMode"]), ("Job", "Indexed"))
        (self.tools / "pomona").symlink_to(PROGRAM)
        (self.path / "batch.toml").write_text(SMALL)
        for index in range(shards["spec"]["completions"]):
            self.run_container(shards, JOB_COMPLETION_INDEX=str(index))
        self.run_container(merge)
        self.merged(self.path / "out")

    def run_container(self, job, **environment):
        (container,) = job["spec"]["template"]["spec"]["containers"]
        words = [*container["command"], *container["args"]]
        here = [word.replace("/batch/", f"{self.path}/").replace("/assets/", f"{self.path}/") for word in words]
        result = subprocess.run(here, env=self.environment(**environment), text=True, capture_output=True)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_name_statuses_as_the_documents_do(self):
        documented = set(re.findall(r"^\| (\d+) \|", (SOURCE / "docs" / "reference" / "commands.md").read_text(), re.M))
        rules = self.read("kubernetes_shards.yaml")["spec"]["podFailurePolicy"]["rules"]
        named = {str(value) for rule in rules for value in rule.get("onExitCodes", {}).get("values", [])}
        self.assertLessEqual(named, documented)
        self.assertTrue(named.isdisjoint({"0", "74", "75"}))

    def test_of_the_page_are_commands_that_there_are(self):
        text = (SOURCE / "docs" / "guides" / "farm.md").read_text()
        typed = [line.strip() for block in re.findall(r"(?:^    .*\n)+", text, re.M) for line in block.splitlines()]
        commands = {tuple(shlex.split(line.split("#")[0])[1:3]) for line in typed if line.startswith("pomona farm ")}
        self.assertEqual(commands, {("farm", "slurm"), ("farm", "status"), ("farm", "commands")})
        for command in commands:
            words = [word for line in typed if tuple(shlex.split(line.split("#")[0])[1:3]) == command
                     for word in re.findall(r"(?<!\S)--[a-z-]+(?==|\s|$)", line.replace("--sbatch=--", "--sbatch= ").split("#")[0])]
            known = self.farm(command[1], "-h").stdout
            for word in words:
                self.assertIn(word, known)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
