"""Folders and buckets behind one interface: names separated by slashes, whole objects in and out."""

import os
import pathlib
import tempfile

MARK = "limber-key"


class Folder:
    """A folder that all machines share. The mark of an object is in a small file beside it, whose name starts with a dot."""

    def __init__(self, path):
        self.root = pathlib.Path(path)

    def names(self):
        for path in sorted(self.root.rglob("*")):
            name = path.relative_to(self.root).as_posix()
            if path.is_file() and not any(part.startswith(".") for part in name.split("/")):
                yield name

    def read(self, name):
        return (self.root / name).read_bytes()

    def mark_of(self, name):
        path, mark = self.root / name, self._mark(name)
        return mark.read_text() if path.exists() and mark.exists() else None

    def write(self, name, data, mark):
        """Writes the mark last: it shows that the object is complete."""
        self._mark(name).unlink(missing_ok=True)
        self._replace(self.root / name, data)
        self._replace(self._mark(name), mark.encode())

    def _mark(self, name):
        path = self.root / name
        return path.with_name(f".{path.name}.key")

    @staticmethod
    def _replace(path, data):
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, partial = tempfile.mkstemp(dir=path.parent, prefix=".part-")
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        os.replace(partial, path)


class Bucket:
    """A bucket of S3 or of a server that speaks its protocol (AWS_ENDPOINT_URL). Objects are written whole, with the mark as metadata."""

    def __init__(self, address):
        import boto3

        self.bucket, _, prefix = address.removeprefix("s3://").partition("/")
        self.prefix = prefix.rstrip("/") + "/" if prefix else ""
        self.client = boto3.client("s3")

    def names(self):
        pages = self.client.get_paginator("list_objects_v2").paginate(Bucket=self.bucket, Prefix=self.prefix)
        for page in pages:
            for entry in page.get("Contents", []):
                yield entry["Key"][len(self.prefix) :]

    def read(self, name):
        return self.client.get_object(Bucket=self.bucket, Key=self.prefix + name)["Body"].read()

    def mark_of(self, name):
        try:
            return self.client.head_object(Bucket=self.bucket, Key=self.prefix + name)["Metadata"].get(MARK)
        except self.client.exceptions.ClientError as error:
            if error.response["Error"]["Code"] in ("404", "NoSuchKey", "NotFound"):
                return None
            raise

    def write(self, name, data, mark):
        self.client.put_object(Bucket=self.bucket, Key=self.prefix + name, Body=data, Metadata={MARK: mark})


def open_storage(address):
    return Bucket(address) if address.startswith("s3://") else Folder(address)
