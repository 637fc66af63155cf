"""The tests that mutants.py asks: which there are, what each comes by and costs, and whether one sees a fault."""

import concurrent.futures
import json
import os
import pathlib
import re
import resource
import subprocess
import tempfile
import time

MEMORY = 6 << 30
# Published hashes are goldens, too: what they see, nobody has said in words.
NEVER = re.compile(r"Verify|PublishedTable")


class Test:
    def __init__(self, name, program, filter_, folder):
        self.name, self.program, self.filter, self.folder = name, program, filter_, folder
        self.seconds, self.reached = 0.0, frozenset()


def tests_of(build):
    """ctest's GoogleTest tests but goldens and those of other programs, by their names."""
    told = subprocess.run(["ctest", "--test-dir", str(build), "--show-only=json-v1"], capture_output=True, text=True, check=True).stdout
    tests = []
    for entry in json.loads(told)["tests"]:
        command = entry.get("command", [])
        labels = [v for p in entry.get("properties", []) if p["name"] == "LABELS" for v in p["value"]]
        if len(command) > 1 and command[1].startswith("--gtest_filter=") and "programs" not in labels and not NEVER.search(entry["name"]):
            program = pathlib.Path(command[0])
            folder = program.parent.relative_to(build / "tests").as_posix()
            tests.append(Test(entry["name"], program, command[1].split("=", 1)[1], folder))
    return sorted(tests, key=lambda test: test.name)


def in_turn(task, items, jobs):
    """What the task gives for each item, so many at a time."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(task, items))


def run(program, filters, seconds, environment, work):
    """How it ended ("" is well), and its processor time. Limits are on processor time, so that a busy machine changes nothing."""
    def limits():
        resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    with tempfile.TemporaryDirectory(dir=work) as own, open(pathlib.Path(own) / "output", "w+", errors="replace") as output:
        words = [str(program), "--gtest_filter=" + ":".join(filters), "--gtest_fail_fast", "--gtest_brief=1"]
        process = subprocess.Popen(words, env={**os.environ, "TMPDIR": own, **environment}, cwd=program.parent, stdout=output,
                                   stderr=subprocess.STDOUT, preexec_fn=limits, start_new_session=True)
        status, used = waited(process, 30 + 20 * seconds)
        output.seek(0)
        failed = re.search(r"\[  FAILED  \] ([\w./]+)", output.read(1 << 20))
    if status == 0:
        return "", used
    return (failed.group(1) if failed else "time" if status in ("time", -24, -9) else f"status {status}"), used


def waited(process, seconds):
    """The status and the processor time of a process, which is ended when it takes longer by the clock."""
    end = time.monotonic() + seconds
    pause = 0.002
    while True:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        if pid:
            process.returncode = os.waitstatus_to_exitcode(status)
            return process.returncode, usage.ru_utime + usage.ru_stime
        if time.monotonic() > end:
            os.killpg(process.pid, 9)
            process.returncode = -9
            usage = os.wait4(process.pid, 0)[2]
            return "time", usage.ru_utime + usage.ru_stime
        time.sleep(pause)
        pause = min(0.1, 1.3 * pause)


# ---- What tests come by ----


def read_notes(work):
    path = work / "reached.tsv"
    lines = path.read_text(encoding="utf-8").splitlines() if path.is_file() else []
    return {fields[0]: fields[1:] for fields in (line.split("\t") for line in lines)}


def note_all(tests, work, names, options):
    """Runs each test by itself without a fault, and notes its processor time and the names of the faults it came by."""
    there = read_notes(work)
    wanted = [test for test in tests if test.name not in there or options.again and re.search(options.again, test.name)]

    def note(test):
        with tempfile.NamedTemporaryFile(dir=work) as places:
            places.truncate(65536)
            ended, used = run(test.program, [test.filter], options.longest, {"POMONA_MUTANT": "0", "POMONA_MUTANT_MAP": places.name}, work)
            reached = [names[n] for n, byte in enumerate(places.read()) if byte and n in names]
        with open(work / "reached.tsv", "a", encoding="utf-8") as file:
            file.write("\t".join((test.name, ended or "passes", f"{used:.3f}", " ".join(reached))) + "\n")

    in_turn(note, wanted, options.jobs)
    bad = [test.name for test in noted(tests, work, passing=False)]
    print(f"{len(tests)} tests, {len(wanted)} noted now; {len(bad)} fail without a fault or take too long, and are not asked: {' '.join(bad)}", flush=True)


def noted(tests, work, passing=True):
    """The tests that pass without a fault (or those that do not), each with its time and what it reaches."""
    there, found = read_notes(work), []
    for test in tests:
        ended, seconds, reached = there.get(test.name, ("unknown", "0", ""))
        test.seconds, test.reached = float(seconds), frozenset(reached.split())
        if (ended == "passes") == passing:
            found.append(test)
    return found


# ---- Whether they see a fault ----


def stages(tests, file):
    """The tests in groups, each of one program and run at once: the cheap ones and those of the fault's folder first."""
    def cost(test):
        return test.seconds * (0.25 if file.startswith(("generator/" + test.folder, test.folder)) else 1)

    groups, ordered, limit = [], sorted(tests, key=lambda test: (cost(test), test.name)), 0.5
    while ordered:
        total, count = 0.0, 0
        while count < len(ordered) and (count == 0 or total + cost(ordered[count]) <= limit):
            total += cost(ordered[count])
            count += 1
        by_program = {}
        for test in ordered[:count]:
            by_program.setdefault(test.program, []).append(test)
        groups += by_program.items()
        ordered, limit = ordered[count:], 2 * limit
    return groups


def show(number, name, file, tests, work, seconds):
    """Which test saw the fault ("" for none), how many tests of those that reach it were asked, and how many those are."""
    reaching, asked, used = [test for test in tests if name in test.reached], 0, 0.0
    for program, group in stages(reaching, file):
        if used >= seconds:
            break
        ended, took = run(program, [test.filter for test in group], 10 + 4 * sum(test.seconds for test in group),
                          {"POMONA_MUTANT": str(number)}, work)
        asked, used = asked + len(group), used + took
        if ended:
            return f"{program.name}: {ended}", asked, len(reaching)
    return "", asked, len(reaching)
