"""Builds a flex of MuJoCo 4 from a settings file of `limber --solver mujoco`.

    settings = json.load(open("horse.settings.json"))
    model = load_mujoco(settings)

For several bodies in one model, write `flexcomp(body, name)` of each into your own MJCF with integrator="discrete", compile it, call
`set_values(model, body, k)` for the k-th flex of the MJCF, from 0, and mujoco.mj_setConst(model, mujoco.MjData(model)) at the end.
"""

import mujoco
import numpy as np


def load_mujoco(settings, index=0, timestep=0.002):
    """The compiled model of one body of the file; vertex v of the flex is vertex v of its `mesh`, in metres. The axes are those of the
    file: gravity is along -y.

    Raises ValueError where the file is of another solver."""
    if settings["solver"] != "mujoco":
        raise ValueError(f"this settings file is for {settings['solver']}: write one with --solver mujoco")
    body = settings["bodies"][index]
    model = mujoco.MjModel.from_xml_string(
        f"""<mujoco><option timestep="{timestep}" gravity="0 -9.81 0" integrator="discrete"/><size memory="1G"/>
<worldbody>{flexcomp(body)}</worldbody></mujoco>"""
    )
    set_values(model, body)
    mujoco.mj_setConst(model, mujoco.MjData(model))
    return model


def flexcomp(body, name="body"):
    """The MJCF element of one body; `name` names the flex, and the bodies of its vertices."""
    engine = body["engine"]
    unit = body.get("unit", 1)
    points = " ".join(f"{unit * x:.9g}" for x in body["mesh"]["positions"])
    triangles = " ".join(map(str, body["mesh"]["triangles"]))
    pins = f'<pin id="{" ".join(map(str, body["pins"]))}"/>' if body["pins"] else ""
    return f"""<flexcomp name="{name}" type="direct" dim="2" mass="{sum(body["mass"]["perVertex"])}" point="{points}"
 element="{triangles}" radius="{body.get("collisionThickness", 0.001)}">
<edge equality="false"/>{pins}
<contact selfcollide="none" friction="{body.get("friction", 1)} 0.005 0.0001"/>
<elasticity young="{engine["young"]}" poisson="{engine["poisson"]}" thickness="{engine["thickness"]}"
 damping="{body.get("damping", 0)}" elastic2d="both"/></flexcomp>"""


def set_values(model, body, flex=0):
    """Gives a compiled flex what MJCF cannot say: a mass for every vertex, carried over from the original, and factors."""
    first, count = model.flex_vertadr[flex], model.flex_vertnum[flex]
    moving = np.setdiff1d(np.arange(count), body["pins"])
    model.body_mass[model.flex_vertbodyid[first + moving]] = np.array(body["mass"]["perVertex"])[moving]
    scale_constraints(model, body, flex)


def scale_constraints(model, body, flex):
    """Factors of single triangles and hinges, where the file has them (--tune constraint or vertex)."""
    triangles = np.array(body["mesh"]["triangles"]).reshape(-1, 3)
    hinges = np.array(body["bend"]["hinges"]).reshape(-1, 4)
    stretch, bend = factors_of(body, "stretch", triangles), factors_of(body, "bend", hinges)
    if stretch is not None:
        rows(model.flex_stiffness, model.flex_stiffnessadr, flex, len(stretch))[:] *= stretch[:, None]
    if bend is not None:
        first, count = model.flex_edgeadr[flex], model.flex_edgenum[flex]
        factor = {tuple(sorted(pair)): value for pair, value in zip(hinges[:, :2].tolist(), bend)}
        own = np.array([factor.get(tuple(sorted(edge)), 1) for edge in model.flex_edge[first : first + count].tolist()])
        rows(model.flex_bending, model.flex_bendingadr, flex, count)[:] *= own[:, None]


def rows(values, addresses, flex, count):
    """The values of one flex among those of all, a row for each of its `count` constraints."""
    end = addresses[flex + 1] if flex + 1 < len(addresses) else len(values)
    return values[addresses[flex] : end].reshape(count, -1)


def factors_of(body, kind, vertices):
    """A factor for each constraint on its `vertices`: its own, or the mean of its vertices'. None where there are none."""
    if body[kind].get("factors"):
        return np.array(body[kind]["factors"])
    field = body.get("vertex", {}).get(kind)
    return np.array(field)[vertices].mean(axis=1) if field else None
