"""Runs examples/scale with several workers, kills one of them with SIGKILL, and compares results with those of limber batch.

    python tests/bench/scale/run_scale.py [--assets 12] [--faces 2000] [--only snakemake|folder|s3]

Needs `npm run build`, and in the Python that runs this: snakemake, ray, boto3, moto[server]. Exit code 0 where all results are equal.
"""

import argparse
import hashlib
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
LIMBER = ROOT / "dist" / "cli" / "limber.mjs"
PROGRAMS = pathlib.Path(sys.executable).parent


def results_of(folder):
    """Hashes of all GLB by name."""
    return {
        path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(pathlib.Path(folder).rglob("*.glb"))
        if ".limber-batch" not in path.parts
    }


def is_below(process, ancestor):
    """Whether a process was started by another one, or by one that it started, and so on."""
    while process > 1:
        if process == ancestor:
            return True
        status = (pathlib.Path("/proc") / str(process) / "status").read_text()
        process = int(next(line for line in status.splitlines() if line.startswith("PPid:")).split()[1])
    return False


def processes(words, ancestor):
    """Ids of processes below `ancestor` whose command line has all the words."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit() or int(entry.name) == os.getpid():
            continue
        try:
            command = (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
            is_own = all(word in command for word in words) and is_below(int(entry.name), ancestor)
        except OSError:
            continue
        if is_own:
            found.append(int(entry.name))
    return found


def kill_one(words, run, done, seconds=60):
    """Kills one process that has the words, once some results are there and the run goes on. Returns whether there was one."""
    end = time.time() + seconds
    while time.time() < end and run.poll() is None:
        if done() > 0:
            for process in processes(words, run.pid):
                os.kill(process, signal.SIGKILL)
                return True
        time.sleep(0.01)
    return False


def check(name, expected, found, was_killed):
    wrong = [key for key in {*expected, *found} if expected.get(key) != found.get(key)]
    ok = was_killed and not wrong
    what = "equal" if not wrong else f"DIFFERENT {sorted(wrong)}"
    print(f"{name}: {len(found)} of {len(expected)} results, a worker {'was' if was_killed else 'was NOT'} killed: {what}", flush=True)
    return ok


def run_snakemake(source, folder, expected, options):
    """Two jobs at a time; one of their batches is killed. Snakemake tries it again."""
    results = folder / "snakemake"
    command = [PROGRAMS / "snakemake", "-s", ROOT / "examples/scale/Snakefile", "--cores", "2", "--retries", "2", "--rerun-incomplete"]
    command += ["--quiet", "all", "--directory", folder / "state", "--config", f"source={source}", f"results={results}"]
    command += [f"limber=node {LIMBER}", f"options={options}"]
    run = subprocess.Popen(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    killed = kill_one(["limber.mjs batch", str(results)], run, lambda: len(results_of(results)) if results.exists() else 0)
    _, errors = run.communicate()
    if run.returncode != 0:
        print(errors[-2000:])
    return check("snakemake, shared folder", expected, results_of(results), killed and run.returncode == 0)


def ray_command(source, results, folder, options):
    script = ROOT / "examples/scale/ray_batch.py"
    words = [sys.executable, script, source, results, "--limber", f"node {LIMBER}", "--options", options]
    return list(map(str, [*words, "--csv", folder / "summary.csv"]))


def run_ray(name, addresses, folder, job):
    """Kills a worker of Ray, then gives the same command again, which finds everything done."""
    expected, options, read = job
    command = ray_command(*addresses, folder, options)
    run = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    killed = kill_one(["ray::optimize"], run, lambda: len(read()), seconds=120)
    output, errors = run.communicate()
    print(output.strip() or errors[-2000:])
    ok = check(name, expected, read(), killed and run.returncode == 0)
    again = subprocess.run(command, capture_output=True, text=True, check=False)
    print(again.stdout.strip() or again.stderr[-2000:])
    return ok and again.stdout.strip() == f"{len(expected)} assets: {len(expected)} up to date"


def start_s3(folder):
    """A server of moto on a free port."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    log = open(folder / "moto.log", "w", encoding="utf-8")
    server = subprocess.Popen([PROGRAMS / "moto_server", "-H", "127.0.0.1", "-p", str(port)], stdout=log, stderr=log)
    os.environ |= {
        "AWS_ENDPOINT_URL": f"http://127.0.0.1:{port}",
        "AWS_ACCESS_KEY_ID": "test",
        "AWS_SECRET_ACCESS_KEY": "test",
        "AWS_DEFAULT_REGION": "us-east-1",
    }
    for _ in range(200):
        with socket.socket() as probe:
            if probe.connect_ex(("127.0.0.1", port)) == 0:
                return server
        time.sleep(0.05)
    raise RuntimeError("moto_server does not answer")


def run_s3(source, folder, expected, options):
    import boto3

    server = start_s3(folder)
    try:
        client = boto3.client("s3")
        client.create_bucket(Bucket="assets")
        for path in sorted(source.rglob("*.obj")):
            client.upload_file(str(path), "assets", f"in/{path.relative_to(source).as_posix()}")

        def read():
            entries = client.list_objects_v2(Bucket="assets", Prefix="out/").get("Contents", [])
            load = lambda key: client.get_object(Bucket="assets", Key=key)["Body"].read()  # noqa: E731
            return {entry["Key"][4:]: hashlib.sha256(load(entry["Key"])).hexdigest() for entry in entries}

        return run_ray("ray, S3 bucket", ("s3://assets/in", "s3://assets/out"), folder, (expected, options, read))
    finally:
        server.kill()
        server.wait()


def run_folder(source, folder, expected, options):
    results = folder / "ray"
    read = lambda: results_of(results) if results.exists() else {}  # noqa: E731
    return run_ray("ray, shared folder", (source, results), folder, (expected, options, read))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--assets", type=int, default=12)
    parser.add_argument("--faces", type=int, default=2000)
    runs = {"snakemake": run_snakemake, "folder": run_folder, "s3": run_s3}
    parser.add_argument("--only", choices=list(runs))
    args = parser.parse_args()
    folder = pathlib.Path(tempfile.mkdtemp(prefix="limber-scale-"))
    source, whole = folder / "source", folder / "whole"
    script = f"import {{ writeAssets }} from '{ROOT / 'tests/bench/batch_assets.mjs'}';"
    script += f"writeAssets('{source}', {{ count: {args.assets}, faces: {args.faces}, seed: 5 }})"
    subprocess.run(["node", "--input-type=module", "-e", script], check=True)
    options = "--ratio 0.4 --soft"
    batch = ["node", LIMBER, "batch", source, whole, "--jobs", "2", "--quiet", *options.split()]
    subprocess.run(list(map(str, batch)), check=True)
    expected = results_of(whole)
    chosen = [runs[args.only]] if args.only else list(runs.values())
    passed = [run(source, folder, expected, options) for run in chosen]
    shutil.rmtree(folder, ignore_errors=True)
    return 0 if len(expected) == args.assets and all(passed) else 1


if __name__ == "__main__":
    sys.exit(main())
