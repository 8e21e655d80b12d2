"""What run.py has measured, kept in the repository: the documents are made from it, and another start adds to it.

record.json has two dictionaries: `motions`, "engine|mesh|scene|method|state" or "engine|mesh|scene|floor" to the deviation of
each start, % of the diagonal, null where it has not been simulated and "diverged" where the body did; and `frequencies`,
"engine|mesh|method" to the mean error, %, untouched and tuned, or "refused". Numbers have six digits.
"""

import json
from pathlib import Path

from tables import STATES

FILE = Path(__file__).with_name("record.json")
DIVERGED = float("inf")


def rounded(value):
    return float(f"{value:.6g}")


class Record:
    """`motions` and `frequencies` with tuples for keys; a body that diverged has the deviation infinity."""

    def __init__(self, text='{"motions": {}, "frequencies": {}}'):
        of = json.loads(text)
        read = lambda value: DIVERGED if value == "diverged" else value
        self.motions = {tuple(key.split("|")): [read(value) for value in values] for key, values in of["motions"].items()}
        self.frequencies = {tuple(key.split("|")): value for key, value in of["frequencies"].items()}

    @classmethod
    def load(cls):
        return cls(FILE.read_text(encoding="utf-8"))

    def add(self, results):
        """Takes over the results of run.py, {"engine|mesh|scene|start|method|state" (or a floor at the end): deviation or None,
        "engine|mesh|method|tuning": ...}."""
        for key, value in results.items():
            *words, last = parts = key.split("|")
            if last == "tuning":
                errors = "refused" if "refused" in value else [rounded(value[state]) for state in STATES]
                self.frequencies[tuple(words)] = errors
                continue
            engine, mesh, scene, start, *subject = parts
            values = self.motions.setdefault((engine, mesh, scene, *subject), [])
            values += [None] * (int(start) + 1 - len(values))
            values[int(start)] = DIVERGED if value is None else rounded(value)

    def text(self):
        write = lambda value: "diverged" if value == DIVERGED else value
        motions = {"|".join(key): [write(value) for value in values] for key, values in sorted(self.motions.items())}
        frequencies = {"|".join(key): value for key, value in sorted(self.frequencies.items())}
        lines = lambda of: ",\n".join(f"    {json.dumps(key)}: {json.dumps(value)}" for key, value in of.items())
        return f'{{\n  "motions": {{\n{lines(motions)}\n  }},\n  "frequencies": {{\n{lines(frequencies)}\n  }}\n}}\n'

    def save(self):
        FILE.write_text(self.text(), encoding="utf-8")
