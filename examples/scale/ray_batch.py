"""Optimizes all models of a shared folder or an S3 bucket with Ray: each model is a task that calls limber optimize.

    python examples/scale/ray_batch.py s3://assets/in s3://assets/out --options "--ratio 0.4" --csv summary.csv
    python examples/scale/ray_batch.py /share/assets /share/results --limber "node /opt/limber/cli/limber.mjs"

A result carries the hash of its input, its options and the version of limber. Up-to-date results are skipped, so that after a crash
of everything the same command continues. The task of a killed worker is repeated by another one. Needs ray, and boto3 for buckets.
The exit code is 1 if a model failed.
"""

import argparse
import collections
import csv
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time
import urllib.parse

import ray

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from storage import open_storage  # noqa: E402

ENDINGS = (".glb", ".gltf", ".obj", ".stl", ".ply")
RETRIES = 3


def companions_of(name, data):
    """Names of the files that a glTF refers to, in its own folder or below; files outside are ignored."""
    if not name.endswith(".gltf"):
        return []
    root = json.loads(data)
    uris = [entry.get("uri", "") for key in ("buffers", "images") for entry in root.get(key, [])]
    paths = [urllib.parse.unquote(uri) for uri in uris if uri and ":" not in uri]
    return sorted({path for path in paths if not path.startswith("/") and ".." not in path.split("/")})


def key_of(files, options, version):
    digest = hashlib.sha256(f"limber-scale/1;{version};{json.dumps(options)};".encode())
    for name, data in sorted(files.items()):
        digest.update(f"{len(name.encode())}:{name}:{len(data)};".encode() + data)
    return digest.hexdigest()


def fetch(storage, name):
    """The model under its own name, and the files that it refers to."""
    folder, _, base = name.rpartition("/")
    files = {base: storage.read(name)}
    for path in companions_of(base, files[base]):
        try:
            files[path] = storage.read(f"{folder}/{path}" if folder else path)
        except Exception:  # limber says in a sentence what is missing
            continue
    return files


def run_limber(limber, files, base, options):
    """The bytes of the result and the warnings of limber, also on what was not fetched; None instead of bytes if it failed."""
    with tempfile.TemporaryDirectory() as folder:
        for path, data in files.items():
            target = pathlib.Path(folder, "in", path)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)
        result = os.path.join(folder, "out.glb")
        command = [*limber, "optimize", os.path.join(folder, "in", base), result, "--threads", "1", *options]
        run = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        # 2: written, but short of a target.
        data = pathlib.Path(result).read_bytes() if run.returncode in (0, 2) else None
        return data, run.stderr.strip()


@ray.remote(max_retries=RETRIES, num_cpus=1)
def optimize(source, results, name, job):
    """One row of the summary. Every failure except that of the worker itself is a row, too."""
    begun = time.time()
    row = {"asset": name, "state": "failed", "bytes before": "", "bytes after": "", "sentence": ""}
    try:
        files = fetch(open_storage(source), name)
        row["bytes before"] = sum(map(len, files.values()))
        key = key_of(files, job["options"], job["version"])
        store, target = open_storage(results), job["names"][name]
        if store.mark_of(target) == key:
            row["state"] = "up to date"
        else:
            data, sentence = run_limber(job["limber"], files, name.rpartition("/")[2], job["options"])
            row["sentence"] = sentence
            if data is not None:
                store.write(target, data, key)
                row.update({"state": "done", "bytes after": len(data)})
    except Exception as error:
        row["sentence"] = f"{type(error).__name__}: {error}"
    row["seconds"] = round(time.time() - begun, 3)
    return row


def result_names(names):
    """Named as by limber batch: two models that would have the same result keep their extensions."""
    short = [name.rpartition(".")[0] for name in names]
    counts = collections.Counter(short)
    return {name: f"{base if counts[base] == 1 else name}.glb" for name, base in zip(names, short)}


def harmless(value):
    """Spreadsheets run texts that start like formulas."""
    return f"'{value}" if isinstance(value, str) and value[:1] in ("=", "+", "-", "@", "\t", "\r") else value


def collect(tasks, most):
    """Rows as they come; only `most` tasks wait in Ray at a time, so that a million models take no more memory than a thousand."""
    waiting = {}
    for submit, name in tasks:
        waiting[submit()] = name
        while len(waiting) >= most:
            yield from finished(waiting)
    while waiting:
        yield from finished(waiting)


def finished(waiting):
    ready, _ = ray.wait(list(waiting), num_returns=1)
    for task in ready:
        name = waiting.pop(task)
        try:
            yield ray.get(task)
        except ray.exceptions.RayError as error:
            yield {"asset": name, "state": "failed", "sentence": f"its workers died {RETRIES + 1} times: {type(error).__name__}"}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source", help="folder or s3://BUCKET/PREFIX")
    parser.add_argument("results", help="folder or s3://BUCKET/PREFIX")
    parser.add_argument("--limber", default="limber", help="the command")
    parser.add_argument("--options", default="", help="of limber optimize")
    parser.add_argument("--csv", default="summary.csv")
    parser.add_argument("--waiting", type=int, default=1000, help="tasks that wait at a time")
    args = parser.parse_args()
    limber = shlex.split(args.limber)
    version = subprocess.run([*limber, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    names = [name for name in open_storage(args.source).names() if name.lower().endswith(ENDINGS)]
    ray.init(include_dashboard=False, log_to_driver=False)
    job = ray.put({"limber": limber, "options": shlex.split(args.options), "version": version, "names": result_names(names)})
    tasks = [(lambda name=name: optimize.remote(args.source, args.results, name, job), name) for name in names]
    counts = {}
    with open(args.csv, "w", newline="", encoding="utf-8") as file:
        fields = ["asset", "state", "bytes before", "bytes after", "seconds", "sentence"]
        writer = csv.DictWriter(file, fields, restval="")
        writer.writeheader()
        for row in collect(tasks, args.waiting):
            writer.writerow({key: harmless(value) for key, value in row.items()})
            file.flush()
            counts[row["state"]] = counts.get(row["state"], 0) + 1
    print(f"{len(names)} assets: " + ", ".join(f"{count} {state}" for state, count in sorted(counts.items())))
    return 1 if counts.get("failed") else 0


if __name__ == "__main__":
    sys.exit(main())
