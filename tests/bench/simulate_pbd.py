"""The same springs in pyPBD: simulate_pbd.py BODY.json SECONDS; JSON on stdout. One XPBD pass per substep, as ours."""

import json
import sys
import time

import numpy
import pypbd

body = json.load(open(sys.argv[1]))
seconds = float(sys.argv[2])
pypbd.Logger.addConsoleSink(pypbd.LogLevel.ERR) if hasattr(pypbd.Logger, "addConsoleSink") else None

simulation = pypbd.Simulation.getCurrent()
simulation.initDefault()
model = simulation.getModel()
points = [numpy.array(body["positions"][i : i + 3]) for i in range(0, len(body["positions"]), 3)]
model.addTriangleModel(points, body["triangles"])
particles = model.getParticles()
for v in range(len(points)):
    particles.setMass(v, 1 / body["inverseMass"])
for v in body["pinned"]:
    particles.setMass(v, 0.0)
for a, b in body["edges"]:
    model.addDistanceConstraint_XPBD(a, b, 1 / body["compliance"])

step = simulation.getTimeStep()
step.setValueUInt(pypbd.TimeStepController.NUM_SUB_STEPS, body["substeps"])
step.setValueUInt(pypbd.TimeStepController.MAX_ITERATIONS, 1)
pypbd.TimeManager.getCurrent().setTimeStepSize(1 / 60)

least = float("inf")
end = time.perf_counter() + seconds
while time.perf_counter() < end:
    start = time.perf_counter()
    step.step(model)
    least = min(least, time.perf_counter() - start)
fallen = particles.getPosition(0)[1] - points[0][1]
print(json.dumps({"secondsPerStep": least, "edges": len(body["edges"]), "version": "2.2.2", "fallen": fallen}))
