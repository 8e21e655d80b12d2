"""What run.py has measured, kept in the repository: the documents are made from it, and another start adds to it.

record.json has three dictionaries: `motions`, "engine|mesh|scene|method|state" or "engine|mesh|scene|floor" to the deviation of
each start, % of the diagonal, null where it has not been simulated and "diverged" where the body did; `rest`, "mesh|method" to the
deviation before anything moves; and `frequencies`, "engine|mesh|method" to the mean error, %, untouched and tuned, or "refused".
Numbers have six digits.
"""

import json
from pathlib import Path

from tables import STATES

FILE = Path(__file__).with_name("record.json")
DIVERGED = float("inf")


def rounded(value):
    return float(f"{value:.6g}")


class Record:
    """`motions`, `rest` and `frequencies` with tuples for keys; a body that diverged has the deviation infinity."""

    def __init__(self, text='{"motions": {}, "rest": {}, "frequencies": {}}'):
        of = json.loads(text)
        read = lambda value: DIVERGED if value == "diverged" else value
        self.motions = {tuple(key.split("|")): [read(value) for value in values] for key, values in of["motions"].items()}
        self.rest = {tuple(key.split("|")): value for key, value in of["rest"].items()}
        self.frequencies = {tuple(key.split("|")): value for key, value in of["frequencies"].items()}

    @classmethod
    def load(cls):
        return cls(FILE.read_text(encoding="utf-8"))

    def add(self, results):
        """Takes over the results of run.py, {"engine|mesh|scene|start|method|state" (or a floor at the end): deviation or None,
        "mesh|method|at rest": deviation, "engine|mesh|method|tuning": ...}."""
        for key, value in results.items():
            *words, last = parts = key.split("|")
            if last == "tuning":
                errors = "refused" if "refused" in value else [rounded(value[state]) for state in STATES]
                self.frequencies[tuple(words)] = errors
                continue
            if last == "at rest":
                self.rest[tuple(words)] = rounded(value)
                continue
            engine, mesh, scene, start, *subject = parts
            values = self.motions.setdefault((engine, mesh, scene, *subject), [])
            values += [None] * (int(start) + 1 - len(values))
            values[int(start)] = DIVERGED if value is None else rounded(value)

    def text(self):
        write = lambda value: "diverged" if value == DIVERGED else value
        parts = {
            "motions": {key: [write(value) for value in values] for key, values in self.motions.items()},
            "rest": self.rest,
            "frequencies": self.frequencies,
        }
        line = lambda key, value: f'    {json.dumps("|".join(key))}: {json.dumps(value)}'
        lines = lambda of: ",\n".join(line(key, value) for key, value in sorted(of.items()))
        return "{\n" + ",\n".join(f'  "{name}": {{\n{lines(of)}\n  }}' for name, of in parts.items()) + "\n}\n"

    def save(self):
        FILE.write_text(self.text(), encoding="utf-8")
