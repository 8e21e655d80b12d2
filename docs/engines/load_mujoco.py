"""Builds a flex of MuJoCo 4 from a settings file of `limber --solver mujoco`.

    settings = json.load(open("horse.settings.json"))
    model = load_mujoco(settings)
"""

import mujoco
import numpy as np


def load_mujoco(settings, index=0, timestep=0.002):
    """The compiled model of one body of the file; vertex v of the flex is vertex v of its `mesh`, in metres. For several bodies in
    one model, put the flexcomp of `mjcf` into your own and give it a name; then set masses and factors as here.

    Raises ValueError where the file is of another solver."""
    if settings["solver"] != "mujoco":
        raise ValueError(f"this settings file is for {settings['solver']}: write one with --solver mujoco")
    body = settings["bodies"][index]
    model = mujoco.MjModel.from_xml_string(mjcf(body, timestep))
    # A flexcomp gives every vertex the same mass; these are carried over from the original.
    moving = np.flatnonzero(model.flex_vertbodyid > 0)
    model.body_mass[model.flex_vertbodyid[moving]] = np.array(body["mass"]["perVertex"])[moving]
    scale_constraints(model, body)
    mujoco.mj_setConst(model, mujoco.MjData(model))
    return model


def mjcf(body, timestep=0.002):
    """The MJCF text of one body, its first frame at rest. The axes are those of the file: gravity is along -y."""
    engine = body["engine"]
    unit = body.get("unit", 1)
    points = " ".join(f"{unit * x:.9g}" for x in body["mesh"]["positions"])
    triangles = " ".join(map(str, body["mesh"]["triangles"]))
    pins = f'<pin id="{" ".join(map(str, body["pins"]))}"/>' if body["pins"] else ""
    return f"""<mujoco><option timestep="{timestep}" gravity="0 -9.81 0" integrator="discrete"/><size memory="1G"/><worldbody>
<flexcomp name="body" type="direct" dim="2" mass="{sum(body["mass"]["perVertex"])}" point="{points}"
 element="{triangles}" radius="{body.get("collisionThickness", 0.001)}">
<edge equality="false"/>{pins}
<contact selfcollide="none" friction="{body.get("friction", 1)} 0.005 0.0001"/>
<elasticity young="{engine["young"]}" poisson="{engine["poisson"]}" thickness="{engine["thickness"]}"
 damping="{body.get("damping", 0)}" elastic2d="both"/></flexcomp></worldbody></mujoco>"""


def scale_constraints(model, body):
    """Factors of single triangles and hinges, where the file has them (--tune constraint or vertex)."""
    triangles = np.array(body["mesh"]["triangles"]).reshape(-1, 3)
    hinges = np.array(body["bend"]["hinges"]).reshape(-1, 4)
    stretch, bend = factors_of(body, "stretch", triangles), factors_of(body, "bend", hinges)
    if stretch is not None:
        model.flex_stiffness[:] = (model.flex_stiffness.reshape(len(stretch), -1) * stretch[:, None]).ravel()
    if bend is not None:
        factor = {tuple(sorted(pair)): value for pair, value in zip(hinges[:, :2].tolist(), bend)}
        own = np.array([factor.get(tuple(sorted(edge)), 1) for edge in model.flex_edge.tolist()])
        model.flex_bending[:] = (model.flex_bending.reshape(len(own), -1) * own[:, None]).ravel()


def factors_of(body, kind, vertices):
    """A factor for each constraint on its `vertices`: its own, or the mean of its vertices'. None where there are none."""
    if body[kind].get("factors"):
        return np.array(body[kind]["factors"])
    field = body.get("vertex", {}).get(kind)
    return np.array(field)[vertices].mean(axis=1) if field else None
