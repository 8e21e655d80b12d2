"""Markdown tables of the results of run.py."""

import re

import numpy as np

import scenes
from simplifiers import METHODS, OURS

FLOORS = ("renumbered", "half the step")
FREQUENCIES = "Frequencies of modes 1 to 10 in our model of each engine"
BEGIN, END = "<!-- tables -->", "<!-- end of tables -->"
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


def number(values):
    """The median of all starts; nothing where nothing has been simulated yet."""
    if not values:
        return "?"
    return "diverged" if median(values) is None else f"{median(values):.3g}"


def cells_of(results):
    """{(engine, kind, size of the motions): {(mesh, scene): {method: {state: [deviation of each start]}}}}"""
    kinds = {entry["name"]: entry["kind"] for entry in scenes.definition["meshes"]}
    found = {}
    for key, value in results.items():
        parts = key.split("|")
        if len(parts) < 5:
            continue
        engine, mesh, scene, _, method = parts[:5]
        state = parts[5] if len(parts) > 5 else "floor"
        size = "small motions" if scene.startswith("small") else ""
        cell = found.setdefault((engine, kinds[mesh], size), {}).setdefault((mesh, scene), {})
        cell.setdefault(method, {}).setdefault(state, []).append(value)
    return found


def median(values):
    return None if not values or any(value is None for value in values) else float(np.median(values))


def tables(results, only_complete=False):
    """Everything that has been simulated; `only_complete`: the scenes in which every mesh has been."""
    parts = []
    for (engine, kind, size), cells in sorted(cells_of(results).items()):
        if only_complete:
            cells = complete_cells(cells)
        if cells:
            title = ", ".join(filter(None, [TITLES[engine], "bodies" if kind == "body" else "sheets", size]))
            parts.append(f"### {title}\n\n{motion_table(cells)}")
    frequencies = {key: value for key, value in results.items() if key.endswith("|tuning")}
    if frequencies:
        parts.append(f"### {FREQUENCIES}\n\n{frequency_table(frequencies)}")
    return "\n\n".join(parts)


def sections_of(text):
    """{heading: what follows it} of the tables of a document."""
    parts = [part.partition("\n") for part in text.split("### ")[1:]]
    return {heading.strip(): rest.strip() for heading, _, rest in parts}


def cells_in(section):
    """The rows of the first table of a section as lists of cells, its header first."""
    lines = [line for line in section.splitlines() if line.startswith("|")]
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    return [row for row in rows if not set("".join(row)) <= set("-: ")]


def means_in(document):
    """[(heading, number of motions, [(method, untouched, tuned)], ratios)] of the tables of motions of a document.

    The ratios are those of the sentence below a table: of ours, tuned, over the best other untouched, and over the best other tuned.
    They come from means before these were rounded.
    """
    found = []
    for title, section in sections_of(document.split(BEGIN)[1].split(END)[0]).items():
        header, *rows = cells_in(section)
        means = next((row for row in rows if row[0].startswith("geometric mean")), None)
        if title == FREQUENCIES or not means:
            continue
        pairs = [(method, *map(float, cell.split(" -> "))) for method, cell in zip(header, means) if " -> " in cell]
        ratios = re.findall(r"by the best peer [^:]*: (\d+\.\d+)", section)[:2]
        found.append((title, int(means[0].split()[-1]), pairs, [float(ratio) for ratio in ratios]))
    return found


def summary(document):
    """One row for each table of motions: ours untouched and tuned, beside the best of the others, both ways; then the POOLS."""
    head = ["", "motions", "Limber untouched", "tuned", "best other untouched", "ratio to it", "best other tuned", "ratio to it"]
    rows = []
    for title, count, means, ratios in means_in(document):
        (_, before, after), *others = sorted(means, key=lambda mean: mean[0] not in OURS)
        untouched, tuned = (min(mean[column] for mean in others) for column in (1, 2))
        numbers = (before, after, untouched, ratios[0], tuned, ratios[1])
        rows.append([title, count, *(f"{value:.2f}" for value in numbers)])
    return table(head, rows + [pooled(document, name, belongs) for name, belongs in POOLS.items()])


def pooled(document, name, belongs):
    """A row of the summary with the geometric means of both ratios over all motions of the tables that belong to a pool."""
    rows = [(count, ratios) for title, count, _, ratios in means_in(document) if belongs(title)]
    counts = [count for count, _ in rows]
    untouched, tuned = (
        np.exp(np.average(np.log([ratios[column] for _, ratios in rows]), weights=counts)) for column in (0, 1)
    )
    return [name, sum(counts), "", "", "", f"{untouched:.2f}", "", f"{tuned:.2f}"]


def merged(old, new):
    """The tables of `new`, and those of `old` that it does not have; of the frequencies also rows."""
    before, after = sections_of(old), sections_of(new)
    sections = {**before, **after}
    if FREQUENCIES in before and FREQUENCIES in after:
        sections[FREQUENCIES] = merged_rows(before[FREQUENCIES], after[FREQUENCIES])
    names = sorted(sections, key=lambda name: (name == FREQUENCIES, name))
    return "\n\n".join(f"### {name}\n\n{sections[name]}" for name in names)


def merged_rows(old, new):
    """The rows of `new`, and those of `old` that it does not have, under the columns of both."""
    columns, rows = [], {}
    for text in (new, old):
        header, *lines = cells_in(text)
        columns += [name for name in header if name not in columns]
        for cells in lines:
            rows.setdefault(tuple(cells[:2]), dict(zip(header, cells)))
    lines = [columns, ["---"] * len(columns), *([row.get(name, "") for name in columns] for row in rows.values())]
    return "\n".join(f"| {' | '.join(cells)} |" for cells in lines)


def methods_of(cells):
    return [method for method in METHODS if any(method in cell for cell in cells.values())]


def complete_cells(cells):
    """The cells of meshes and scenes where each method that occurs at all moved, untouched and tuned."""
    methods = methods_of(cells)
    return {
        name: cell for name, cell in cells.items()
        if all(median(cell.get(m, {}).get(s)) is not None for m in methods for s in ("untouched", "tuned"))
    }


def motion_table(cells):
    methods, complete = methods_of(cells), complete_cells(cells)
    rows, gathered = [], {(method, state): [] for method in methods for state in ("untouched", "tuned")}
    for (mesh, scene), cell in cells.items():
        row = [f"{mesh}, {scene}"]
        for method in methods:
            states = cell.get(method, {})
            row.append(" -> ".join(number(states.get(state)) for state in ("untouched", "tuned")) if states else "")
            for state in ("untouched", "tuned"):
                if (mesh, scene) in complete:
                    gathered[method, state].append(median(states[state]))
        floors = [number(cell[floor]["floor"]) if floor in cell else "-" for floor in FLOORS]
        row.append(" / ".join(floors) if any(floor in cell for floor in FLOORS) else "")
        rows.append(row)
    head = ["", *methods, "renumbered / half the step"]
    if not complete:
        return table(head, rows)
    means = [f"geometric mean of {len(complete)}"]
    for method in methods:
        means.append(" -> ".join(f"{geometric(gathered[method, state]):.3g}" for state in ("untouched", "tuned")))
    return table(head, [*rows, [*means, ""]]) + best_peer_note(gathered, methods) + exceptions(complete, gathered, methods)


def best_peer_note(gathered, methods):
    peers = [method for method in methods if method not in OURS]
    if not peers:
        return ""
    best = min(peers, key=lambda method: geometric(gathered[method, "untouched"]))
    least = min(peers, key=lambda method: geometric(gathered[method, "tuned"]))
    lines = []
    for ours in [method for method in methods if method in OURS]:
        against = geometric(gathered[ours, "tuned"]) / geometric(gathered[best, "untouched"])
        alike = geometric(gathered[ours, "tuned"]) / geometric(gathered[least, "tuned"])
        lines.append(f"`{ours}` tuned, divided by the best peer untouched ({best}): {against:.2f}; by the best peer tuned in the "
                     f"same way ({least}): {alike:.2f}.")
    return "\n\n" + " ".join(lines)


# A motion of ours counts as worse than another's from so many times its deviation on, noise apart.
WORSE = 1.25


def exceptions(cells, gathered, methods):
    """The motions in which ours is worse than the tool that is best untouched, beyond noise."""
    peers = [method for method in methods if method not in OURS]
    if not peers:
        return ""
    best = min(peers, key=lambda method: geometric(gathered[method, "untouched"]))
    names = []
    for (mesh, scene), cell in cells.items():
        noise = max((median(cell[floor]["floor"]) or 0 for floor in FLOORS if floor in cell), default=0)
        ours, other = median(cell[OURS[0]]["tuned"]), median(cell[best]["untouched"])
        if ours > WORSE * other + noise:
            names.append(f"{mesh}, {scene}")
    return f" Worse than {best} untouched by more than {WORSE} times and the noise: {'; '.join(names) or 'none'}."


def frequency_cell(value):
    if not value:
        return ""
    return "refused" if "refused" in value else f"{value['untouched']:.1f} -> {value['tuned']:.1f}"


def frequency_table(frequencies):
    found = {}
    for key, value in frequencies.items():
        engine, mesh, method, _ = key.split("|")
        found.setdefault((engine, mesh), {})[method] = value
    rows, methods = [], [method for method in METHODS if any(method in of for of in found.values())]
    for (engine, mesh), of in found.items():
        row = [engine, mesh]
        for method in methods:
            row.append(frequency_cell(of.get(method)))
        rows.append(row)
    return table(["engine", "mesh", *methods], rows)
