"""Builds a flex of MuJoCo 4 from a settings file of `limber --solver mujoco`.

    settings = json.load(open("horse.settings.json"))
    model = load_mujoco(settings["bodies"][0])
"""

import mujoco
import numpy as np


def mjcf(body, timestep=0.002):
    """The MJCF text of one body of the file, its first frame at rest. Gravity is MuJoCo's default, along -z."""
    engine = {**body["engine"]}
    unit = body.get("unit", 1)
    points = " ".join(f"{unit * x:.9g}" for x in body["mesh"]["positions"])
    triangles = " ".join(map(str, body["mesh"]["triangles"]))
    pins = f'<pin id="{" ".join(map(str, body["pins"]))}"/>' if body["pins"] else ""
    return f"""<mujoco><option timestep="{timestep}" integrator="discrete"/><size memory="1G"/><worldbody>
<flexcomp name="body" type="direct" dim="2" mass="{sum(body["mass"]["perVertex"])}" point="{points}"
 element="{triangles}" radius="{body.get("collisionThickness", 0.001)}">
<edge equality="false"/>{pins}
<contact selfcollide="none"/>
<elasticity young="{engine["young"]}" poisson="{engine["poisson"]}" thickness="{engine["thickness"]}"
 damping="{body.get("damping", 0)}" elastic2d="both"/></flexcomp></worldbody></mujoco>"""


def load_mujoco(body, timestep=0.002):
    """The compiled model; vertex v of the flex is vertex v of body["mesh"]."""
    model = mujoco.MjModel.from_xml_string(mjcf(body, timestep))
    # A flexcomp gives every vertex the same mass; these are carried over from the original.
    moving = np.flatnonzero(model.flex_vertbodyid > 0)
    model.body_mass[model.flex_vertbodyid[moving]] = np.array(body["mass"]["perVertex"])[moving]
    scale_constraints(model, body)
    mujoco.mj_setConst(model, mujoco.MjData(model))
    return model


def scale_constraints(model, body):
    """Factors of single triangles and hinges, where the file has them (--tune constraint)."""
    stretch, bend = body["stretch"].get("factors"), body["bend"].get("factors")
    if stretch:
        model.flex_stiffness[:] = (model.flex_stiffness.reshape(len(stretch), -1) * np.array(stretch)[:, None]).ravel()
    if bend:
        ends = np.array(body["bend"]["hinges"]).reshape(-1, 4)[:, :2]
        factor = {tuple(sorted(pair)): value for pair, value in zip(ends.tolist(), bend)}
        own = np.array([factor.get(tuple(sorted(edge)), 1) for edge in model.flex_edge.tolist()])
        model.flex_bending[:] = (model.flex_bending.reshape(len(own), -1) * own[:, None]).ravel()
