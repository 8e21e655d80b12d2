// Builds a soft body of Jolt Physics (npm jolt-physics 1.1) from a settings file of `limber --solver jolt`.
//
//   const settings = JSON.parse(await readFile('horse.settings.json', 'utf8'));
//   const creation = joltSoftBody(Jolt, settings.bodies[0], objectLayer);
//   bodies.AddBody(bodies.CreateSoftBody(creation).GetID(), Jolt.EActivation_Activate);

/** A SoftBodyCreationSettings of one body of the file. Vertex v is vertex v of `body.mesh`, in metres. */
export function joltSoftBody(Jolt, body, objectLayer) {
  const { mesh, mass, pins, stretch, bend, unit = 1 } = body;
  const shared = new Jolt.SoftBodySharedSettings();
  const isPinned = new Set(pins);
  for (let v = 0; v < mesh.positions.length / 3; v++) {
    const vertex = new Jolt.SoftBodySharedSettingsVertex();
    const [x, y, z] = mesh.positions.slice(3 * v, 3 * v + 3).map((value) => value * unit);
    vertex.mPosition = new Jolt.Float3(x, y, z);
    vertex.mInvMass = isPinned.has(v) ? 0 : 1 / mass.perVertex[v];
    shared.mVertices.push_back(vertex);
  }
  for (let t = 0; t < mesh.triangles.length; t += 3)
    shared.AddFace(new Jolt.SoftBodySharedSettingsFace(...mesh.triangles.slice(t, t + 3), 0));
  // Jolt takes compliances: one over the stiffness of each constraint.
  const compliance = ({ constant, factors }, c) => 1 / (constant * (factors?.[c] ?? 1));
  for (let c = 0; c < stretch.pairs.length / 2; c++) {
    const [i, j] = stretch.pairs.slice(2 * c, 2 * c + 2);
    shared.mEdgeConstraints.push_back(new Jolt.SoftBodySharedSettingsEdge(i, j, compliance(stretch, c)));
  }
  for (let c = 0; c < bend.hinges.length / 4; c++) {
    const vertices = bend.hinges.slice(4 * c, 4 * c + 4);
    shared.mDihedralBendConstraints.push_back(
      new Jolt.SoftBodySharedSettingsDihedralBend(...vertices, compliance(bend, c)),
    );
  }
  shared.CalculateEdgeLengths();
  shared.CalculateBendConstraintConstants();
  shared.Optimize();
  const creation = new Jolt.SoftBodyCreationSettings(
    shared,
    new Jolt.RVec3(0, 0, 0),
    new Jolt.Quat(0, 0, 0, 1),
    objectLayer,
  );
  // An iteration is a substep with one pass of XPBD, so that fewer of them make the body softer.
  creation.mNumIterations = body.substeps ?? 20;
  creation.mLinearDamping = body.damping ?? 0;
  creation.mFriction = body.friction ?? creation.mFriction;
  creation.mVertexRadius = body.collisionThickness ?? 0;
  // Vertices stay in the space of the mesh.
  creation.mUpdatePosition = false;
  return creation;
}
