// Moves one soft body of Jolt: jolt_run.mjs JOB.json RESULT.bin; the result is float32 positions [frame][vertex][3].
// JOB: { body (of a settings file), start, velocity, step, frames, iterations, forces ([frame][vertex][3], N, or null) }.
// Jolt is the devDependency of the project, or the module $LIMBER_JOLT.

import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { joltSoftBody } from '../../../docs/engines/load_jolt.mjs';

const [file, target] = process.argv.slice(2);
const { body, start, velocity, step, frames, iterations, forces } = JSON.parse(readFileSync(file, 'utf8'));
const module = process.env.LIMBER_JOLT ? pathToFileURL(process.env.LIMBER_JOLT).href : 'jolt-physics';
const { default: initJolt } = await import(module);
const Jolt = await initJolt();
const jolt = new Jolt.JoltInterface(worldSettings());
const system = jolt.GetPhysicsSystem();
system.SetGravity(new Jolt.Vec3(0, 0, 0));
const bodies = system.GetBodyInterface();

function worldSettings() {
  const settings = new Jolt.JoltSettings();
  const pairs = new Jolt.ObjectLayerPairFilterTable(1);
  const layers = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
  layers.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = layers;
  settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
  settings.mMaxWorkerThreads = 0;
  return settings;
}

const creation = joltSoftBody(Jolt, { solver: 'jolt', bodies: [body] });
creation.mNumIterations = iterations;
creation.mAllowSleeping = false;
const made = bodies.CreateSoftBody(creation);
bodies.AddBody(made.GetID(), Jolt.EActivation_Activate);
const motion = Jolt.castObject(made.GetMotionProperties(), Jolt.SoftBodyMotionProperties);
const vertices = motion.GetVertices();
const count = start.length / 3;
const moving = Array.from({ length: count }, (_, v) => v).filter((v) => !body.pins.includes(v));
for (const v of moving) {
  vertices.at(v).mPosition = new Jolt.Vec3(...start.slice(3 * v, 3 * v + 3));
  vertices.at(v).mVelocity = new Jolt.Vec3(...velocity.slice(3 * v, 3 * v + 3));
}
const result = new Float32Array(3 * count * frames);
for (let frame = 0; frame < frames; frame++) {
  if (forces) push(frame);
  jolt.Step(step, 1);
  for (let v = 0; v < count; v++) {
    const place = vertices.at(v).mPosition;
    result.set([place.GetX(), place.GetY(), place.GetZ()], 3 * (frame * count + v));
  }
}
writeFileSync(target, Buffer.from(result.buffer));

/** The impulse of the frame's forces, added to velocities before the step. */
function push(frame) {
  for (const v of moving) {
    const scale = step / body.mass.perVertex[v];
    const before = vertices.at(v).mVelocity;
    const [x, y, z] = forces[frame].slice(3 * v, 3 * v + 3).map((force) => scale * force);
    vertices.at(v).mVelocity = new Jolt.Vec3(before.GetX() + x, before.GetY() + y, before.GetZ() + z);
  }
}
