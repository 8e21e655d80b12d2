// Builds a soft body of Jolt Physics (npm jolt-physics 1.1) from a settings file of `limber --solver jolt`.
//
//   const Jolt = await initJolt(); // and `jolt`, your JoltInterface
//   const settings = JSON.parse(await readFile('horse.settings.json', 'utf8'));
//   const creation = joltSoftBody(Jolt, settings, { objectLayer });
//   const bodyInterface = jolt.GetPhysicsSystem().GetBodyInterface();
//   const body = bodyInterface.CreateSoftBody(creation);
//   bodyInterface.AddBody(body.GetID(), Jolt.EActivation_Activate);

/**
 * A SoftBodyCreationSettings of one body of the file; the caller destroys it. Vertex v of the soft body is vertex v of the body's
 * `mesh`, in metres, with the axes of the file: y is up, as Jolt's default gravity has it. `step`: seconds of a step of the
 * simulation. Throws where the file is of another solver.
 */
export function joltSoftBody(Jolt, settings, { objectLayer = 0, index = 0, step = 1 / 60 } = {}) {
  if (settings.solver !== 'jolt')
    throw new Error(`This settings file is for ${settings.solver}: write one with --solver jolt.`);
  const body = settings.bodies[index];
  const shared = new Jolt.SoftBodySharedSettings();
  addVertices(Jolt, shared, body);
  for (const corners of groups(body.mesh.triangles, 3))
    added(Jolt, new Jolt.SoftBodySharedSettingsFace(...corners, 0), (face) => shared.AddFace(face));
  addConstraints(Jolt, shared, body);
  shared.CalculateEdgeLengths();
  shared.CalculateBendConstraintConstants();
  shared.Optimize();
  const creation = atOrigin(Jolt, shared, objectLayer);
  // An iteration is a substep with one pass of XPBD, so that fewer of them make the body softer. The file counts those of a step of
  // 1/60 s, and none where no number is enough, as where a triangle has no area: 20 are then a start, not a bound.
  const wanted = Math.ceil((body.substeps ?? 20) * 60 * step - 1e-6);
  creation.mNumIterations = Math.max(1, Math.min(wanted, mostIterations(body, step)));
  creation.mLinearDamping = body.damping ?? 0;
  creation.mFriction = body.friction ?? creation.mFriction;
  creation.mVertexRadius = body.collisionThickness ?? 0;
  // Vertices stay in the space of the mesh.
  creation.mUpdatePosition = false;
  return creation;
}

/**
 * Positions are floats. Where substeps are so short that gravity changes a position by less than its rounding, a body at rest never
 * falls: up to this number it changes by at least 16 units in the last place, which keeps gravity within 3 %.
 */
function mostIterations({ mesh, unit = 1 }, step) {
  const farthest = unit * mesh.positions.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  return Math.floor(step / Math.sqrt((16 * 2 ** -23 * farthest) / 9.81));
}

function addVertices(Jolt, shared, { mesh, mass, pins, unit = 1 }) {
  const isPinned = new Set(pins);
  groups(mesh.positions, 3).forEach((place, v) => {
    const vertex = new Jolt.SoftBodySharedSettingsVertex();
    added(Jolt, new Jolt.Float3(...place.map((value) => value * unit)), (position) => {
      vertex.mPosition = position;
    });
    vertex.mInvMass = isPinned.has(v) ? 0 : 1 / mass.perVertex[v];
    added(Jolt, vertex, () => shared.mVertices.push_back(vertex));
  });
}

function addConstraints(Jolt, shared, body) {
  groups(body.stretch.pairs, 2).forEach((ends, c) => {
    const edge = new Jolt.SoftBodySharedSettingsEdge(...ends, compliance(body, 'stretch', ends, c));
    added(Jolt, edge, () => shared.mEdgeConstraints.push_back(edge));
  });
  groups(body.bend.hinges, 4).forEach((corners, c) => {
    const hinge = new Jolt.SoftBodySharedSettingsDihedralBend(
      ...corners,
      compliance(body, 'bend', corners, c),
    );
    added(Jolt, hinge, () => shared.mDihedralBendConstraints.push_back(hinge));
  });
}

/**
 * Jolt takes compliances: one over the stiffness of each constraint, which is `constant` times its factor of --tune constraint, or
 * times the mean of its vertices' factors of --tune vertex.
 */
function compliance(body, kind, vertices, c) {
  const { constant, factors } = body[kind];
  const map = body.vertex?.[kind];
  const mean = map ? vertices.reduce((sum, v) => sum + map[v], 0) / vertices.length : 1;
  return 1 / (constant * (factors?.[c] ?? mean));
}

function atOrigin(Jolt, shared, objectLayer) {
  const [place, turn] = [new Jolt.RVec3(0, 0, 0), new Jolt.Quat(0, 0, 0, 1)];
  const creation = new Jolt.SoftBodyCreationSettings(shared, place, turn, objectLayer);
  Jolt.destroy(place);
  Jolt.destroy(turn);
  return creation;
}

/** Jolt keeps copies, and what JavaScript has made stays in its memory until it is destroyed. */
function added(Jolt, made, add) {
  add(made);
  Jolt.destroy(made);
}

const groups = (list, size) =>
  Array.from({ length: list.length / size }, (_, k) => list.slice(size * k, size * (k + 1)));
