"""Markdown tables of what is in record.py."""

import numpy as np

import scenes
from simplifiers import METHODS, OURS

STATES = ("untouched", "tuned")
FLOORS = ("renumbered", "half the step")
REST = "At rest"
FREQUENCIES = "Frequencies of modes 1 to 10 in our model of each engine"
TITLES = {"mujoco": "MuJoCo", "newton": "Newton", "jolt": "Jolt", "blender": "Blender"}
# Rows below those of the summary: ratios over the motions of several tables.
POOLS = {
    "bodies in MuJoCo and Newton": lambda title: "bodies" in title and title.startswith(("MuJoCo", "Newton")),
    "sheets in Blender, MuJoCo and Newton": lambda title: "sheets" in title and not title.startswith("Jolt"),
    "everything": lambda title: True,
}


def geometric(values):
    return float(np.exp(np.mean(np.log(values))))


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines)


def cells_of(motions):
    """{title of the table: {(mesh, scene): {(method, state) or (floor,): [deviation of each start]}}}, as a Record has them."""
    kinds = {entry["name"]: entry["kind"] for entry in scenes.definition["meshes"]}
    found = {}
    for (engine, mesh, scene, *subject), values in motions.items():
        size = "small motions" if scene.startswith("small") else ""
        title = ", ".join(filter(None, [TITLES[engine], "bodies" if kinds[mesh] == "body" else "sheets", size]))
        found.setdefault(title, {}).setdefault((mesh, scene), {})[tuple(subject)] = known(values)
    return dict(sorted(found.items()))


def known(values):
    """Without the starts that have not been simulated; a body that diverged has infinity."""
    return [value for value in values if value is not None]


def median(values):
    """Infinity where the body diverged from any start."""
    if not values:
        return None
    return float(np.median(values)) if np.isfinite(values).all() else float("inf")


def number(values):
    """The median of all starts; nothing where nothing has been simulated yet."""
    if not values:
        return "?"
    return f"{median(values):.3g}" if np.isfinite(median(values)) else "diverged"


def tables(record, only_complete=False):
    """Everything that has been simulated; `only_complete`: the scenes in which every mesh has been."""
    parts = []
    for title, cells in cells_of(record.motions).items():
        if only_complete:
            cells = complete_cells(cells)
        if cells:
            parts.append(f"### {title}\n\n{motion_table(cells)}")
    if record.rest:
        parts.append(f"### {REST}\n\n{rest_table(record.rest)}")
    if record.frequencies:
        parts.append(f"### {FREQUENCIES}\n\n{frequency_table(record.frequencies)}")
    return "\n\n".join(parts)


def means(cells):
    """{(method, state): geometric mean over the motions in which every mesh moved}"""
    complete = complete_cells(cells).values()
    return {
        (method, state): geometric([median(cell[method, state]) for cell in complete])
        for method in methods_of(cells) for state in STATES
    } if complete else {}


def best_other(found, state):
    """The other tool whose meshes are nearest over a table, of the means of that table."""
    others = [method for method, of in found if of == state and method not in OURS]
    return min(others, key=lambda method: found[method, state]) if others else None


def ratios(found):
    """Of ours, tuned, over the best other untouched, and over the best other tuned in the same way."""
    return [found[OURS[0], "tuned"] / found[best_other(found, state), state] for state in STATES]


def summary(record):
    """One row for each table of motions: ours untouched and tuned, beside the best of the others, both ways; then the POOLS."""
    head = ["", "motions", "Limber untouched", "tuned", "best other untouched", "ratio to it", "best other tuned", "ratio to it"]
    rows, gathered = [], []
    for title, cells in cells_of(record.motions).items():
        found, count = means(cells), len(complete_cells(cells))
        if not count:
            continue
        before, after = (found[OURS[0], state] for state in STATES)
        untouched, tuned = (found[best_other(found, state), state] for state in STATES)
        against, alike = ratios(found)
        numbers = (before, after, untouched, against, tuned, alike)
        rows.append([title, count, *(f"{value:.2f}" for value in numbers)])
        gathered.append((title, count, (against, alike)))
    return table(head, rows + [pooled(gathered, name, belongs) for name, belongs in POOLS.items()])


def pooled(gathered, name, belongs):
    """A row of the summary with the geometric means of both ratios over all motions of the tables that belong to a pool."""
    rows = [(count, pair) for title, count, pair in gathered if belongs(title)]
    counts = [count for count, _ in rows]
    untouched, tuned = (
        np.exp(np.average(np.log([pair[column] for _, pair in rows]), weights=counts)) for column in (0, 1)
    )
    return [name, sum(counts), "", "", "", f"{untouched:.2f}", "", f"{tuned:.2f}"]


def methods_of(cells):
    return [method for method in METHODS if any((method, state) in cell for cell in cells.values() for state in STATES)]


def complete_cells(cells):
    """The cells of meshes and scenes where each method that occurs at all moved, untouched and tuned."""
    methods = methods_of(cells)
    moved = lambda cell, m, s: cell.get((m, s)) and np.isfinite(median(cell[m, s]))
    return {name: cell for name, cell in cells.items() if all(moved(cell, m, s) for m in methods for s in STATES)}


def starts_note(cells):
    """How many starts the medians are of."""
    counts = {len(values) for cell in cells.values() for subject, values in cell.items() if len(subject) == 2}
    few, many = min(counts), max(counts)
    number = str(few) if few == many else f"{few} to {many}"
    return f"Median of {number} start{'s' if many > 1 else ''}."


def motion_table(cells):
    methods, found, rows = methods_of(cells), means(cells), []
    arrow = lambda of: " -> ".join(of(state) for state in STATES)
    for (mesh, scene), cell in cells.items():
        row = [f"{mesh}, {scene}", *(arrow(lambda state: number(cell.get((method, state)))) for method in methods)]
        noise = [number(cell[floor,]) if (floor,) in cell else "-" for floor in FLOORS]
        rows.append([*row, " / ".join(noise) if any((floor,) in cell for floor in FLOORS) else ""])
    head = ["", *methods, "renumbered / half the step"]
    if not found:
        return table(head, rows)
    last = [f"geometric mean of {len(complete_cells(cells))}",
            *(arrow(lambda state: f"{found[method, state]:.3g}") for method in methods), ""]
    notes = [starts_note(cells), best_peer_note(found), hindsight_note(cells, found), exceptions(cells, found)]
    return "\n\n".join([table(head, [*rows, last]), " ".join(filter(None, notes))])


def best_peer_note(found):
    untouched, tuned = (best_other(found, state) for state in STATES)
    if not untouched:
        return ""
    against, alike = ratios(found)
    return (f"`{OURS[0]}` tuned, divided by the best peer untouched ({untouched}): {against:.2f}; by the best peer tuned in the "
            f"same way ({tuned}): {alike:.2f}.")


def hindsight_note(cells, found):
    """How near the tuned meshes together come: a bound on what choosing among them could gain."""
    best = best_other(found, "untouched")
    if not best:
        return ""
    methods = methods_of(cells)
    nearest = geometric([min(median(cell[method, "tuned"]) for method in methods) for cell in complete_cells(cells).values()])
    return f"The nearest tuned mesh of each motion, chosen afterwards: {nearest / found[best, 'untouched']:.2f}."


# A motion of ours counts as worse than another's from so many times its deviation on, noise apart.
WORSE = 1.25


def exceptions(cells, found):
    """The motions in which ours is worse than the tool that is best untouched, beyond noise."""
    best = best_other(found, "untouched")
    if not best:
        return ""
    names = []
    for (mesh, scene), cell in complete_cells(cells).items():
        noise = max((median(cell[floor,]) for floor in FLOORS if (floor,) in cell), default=0)
        if median(cell[OURS[0], "tuned"]) > WORSE * median(cell[best, "untouched"]) + noise:
            names.append(f"{mesh}, {scene}")
    return f"Worse than {best} untouched by more than {WORSE} times and the noise: {'; '.join(names) or 'none'}."


def rest_table(rest):
    methods = [method for method in METHODS if any(method == of for _, of in rest)]
    meshes = dict.fromkeys(mesh for mesh, _ in sorted(rest))
    value = lambda mesh, method: f"{rest[mesh, method]:.3g}" if (mesh, method) in rest else ""
    return table(["mesh", *methods], [[mesh, *(value(mesh, method) for method in methods)] for mesh in meshes])


def frequency_cell(value):
    if not value:
        return ""
    return "refused" if value == "refused" else f"{value[0]:.1f} -> {value[1]:.1f}"


def frequency_table(frequencies):
    found = {}
    for (engine, mesh, method), value in frequencies.items():
        found.setdefault((engine, mesh), {})[method] = value
    methods = [method for method in METHODS if any(method in of for of in found.values())]
    rows = [[*name, *(frequency_cell(of.get(method)) for method in methods)] for name, of in found.items()]
    return table(["engine", "mesh", *methods], rows)
