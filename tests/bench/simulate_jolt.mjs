// Simulates the same springs as a soft body of jolt-physics: simulate_jolt.mjs JOLT_MODULE BODY.json SECONDS; JSON on stdout.
// Jolt's iterations are substeps (XPBD with one pass each), like ours.

import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const [module, file, seconds] = process.argv.slice(2);
const { positions, triangles, edges, pinned, substeps, compliance, inverseMass } = JSON.parse(
  readFileSync(file, 'utf8'),
);
const { default: initJolt } = await import(pathToFileURL(module).href);
const Jolt = await initJolt();

const [still, moving] = [0, 1];
const settings = new Jolt.JoltSettings();
const pairs = new Jolt.ObjectLayerPairFilterTable(2);
pairs.EnableCollision(still, moving);
const layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
layers.MapObjectToBroadPhaseLayer(still, new Jolt.BroadPhaseLayer(0));
layers.MapObjectToBroadPhaseLayer(moving, new Jolt.BroadPhaseLayer(1));
settings.mObjectLayerPairFilter = pairs;
settings.mBroadPhaseLayerInterface = layers;
settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
settings.mMaxWorkerThreads = 0;
const jolt = new Jolt.JoltInterface(settings);
const bodies = jolt.GetPhysicsSystem().GetBodyInterface();

const shared = new Jolt.SoftBodySharedSettings();
const isPinned = new Set(pinned);
for (let v = 0; v < positions.length / 3; v++) {
  const vertex = new Jolt.SoftBodySharedSettingsVertex();
  vertex.mPosition = new Jolt.Float3(...positions.slice(3 * v, 3 * v + 3));
  vertex.mInvMass = isPinned.has(v) ? 0 : inverseMass;
  shared.mVertices.push_back(vertex);
}
for (let t = 0; t < triangles.length; t += 3)
  shared.AddFace(new Jolt.SoftBodySharedSettingsFace(...triangles.slice(t, t + 3), 0));
for (const [a, b] of edges)
  shared.mEdgeConstraints.push_back(new Jolt.SoftBodySharedSettingsEdge(a, b, compliance));
shared.CalculateEdgeLengths();
shared.Optimize();
const creation = new Jolt.SoftBodyCreationSettings(
  shared,
  new Jolt.RVec3(0, 0, 0),
  new Jolt.Quat(0, 0, 0, 1),
  moving,
);
creation.mNumIterations = substeps;
creation.mLinearDamping = 0;
creation.mUpdatePosition = false;
bodies.AddBody(bodies.CreateSoftBody(creation).GetID(), Jolt.EActivation_Activate);

let least = Infinity;
const end = performance.now() + 1000 * Number(seconds);
while (performance.now() < end) {
  const start = performance.now();
  jolt.Step(1 / 60, 1);
  least = Math.min(least, performance.now() - start);
}
console.log(JSON.stringify({ secondsPerStep: least / 1000, edges: shared.mEdgeConstraints.size() }));
