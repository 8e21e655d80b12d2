/** Files of models with a mistake: name, content, and how the content is told if not as it is. */

type ModelFile = readonly [name: string, content: string, told?: string];

const obj = (text: string): [string, string] => ['a.obj', text];
const VERTICES = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n';

const OBJ = [
  '',
  '\n\n',
  '# nothing\n',
  'v 0 0 0\n',
  VERTICES,
  `${VERTICES}f 1 2 4\n`,
  `${VERTICES}f 0 1 2\n`,
  `${VERTICES}f -4 1 2\n`,
  `${VERTICES}f a b c\n`,
  `${VERTICES}f 1.5 2 3\n`,
  'v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n',
  'v a b c\nv 1 0 0\nv 0 1 0\nf 1 2 3\n',
  'v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n',
  'v 1e999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n',
  `${VERTICES}l 1 2 3\n`,
  `${VERTICES}p 1 2 3\n`,
  `${VERTICES}f 1 2 99999999999\n`,
  'solid a\nfacet normal 0 0 1\n',
  '\u0000\u0001\u0002\u0003',
  '<html><body>Not found</body></html>',
  '{"asset":{"version":"2.0"}}',
].map(obj);

const ply = (header: string, body = ''): [string, string] => ['a.ply', `ply\n${header}\nend_header\n${body}`];
const XYZ = 'property float x\nproperty float y\nproperty float z';
const FACES = 'element face 1\nproperty list uchar int vertex_indices';
const CORNERS = '0 0 0\n1 0 0\n0 1 0\n';

const PLY: [string, string][] = [
  ['a.ply', ''],
  ['a.ply', 'ply'],
  ['a.ply', 'ply\n'],
  ['a.ply', 'plx\nformat ascii 1.0\nend_header\n'],
  ['a.ply', 'ply\nformat ascii 1.0\nelement vertex 3\n'],
  ply('format utf8 1.0'),
  ply('format ascii 2.0'),
  ply('element vertex 3'),
  ply('format ascii 1.0'),
  ply(`format ascii 1.0\nelement vertex x\n${XYZ}`),
  ply(`format ascii 1.0\nelement vertex -3\n${XYZ}`),
  ply(
    `format ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n${FACES}`,
    `${CORNERS}3 0 1 2\n`,
  ),
  ply(`format ascii 1.0\nelement vertex 3\nproperty quad x\n${FACES}`, `${CORNERS}3 0 1 2\n`),
  ply(`format ascii 1.0\nproperty float x\nelement vertex 3\n${XYZ}`),
  ply(`format ascii 1.0\nelement vertex 3\n${XYZ}`, CORNERS),
  ply(`format ascii 1.0\nelement vertex 3\n${XYZ}\n${FACES}`, CORNERS),
  ply(`format ascii 1.0\nelement vertex 3\n${XYZ}\n${FACES}`, `${CORNERS}3 0 1\n`),
  ply(`format ascii 1.0\nelement vertex 3\n${XYZ}\n${FACES}`, `${CORNERS}3 0 1 3\n`),
  ply(`format ascii 1.0\nelement vertex 3\n${XYZ}\n${FACES}`, `${CORNERS}3 0 1 -1\n`),
  ply(`format ascii 1.0\nelement vertex 3\n${XYZ}\n${FACES}`, `${CORNERS}x 0 1 2\n`),
  ply(`format ascii 1.0\nelement vertex 3\n${XYZ}\n${FACES}`, 'a b c\n1 0 0\n0 1 0\n3 0 1 2\n'),
  ply(
    `format ascii 1.0\nelement vertex 3\n${XYZ}\nelement face 1\nproperty int vertex_indices`,
    `${CORNERS}0\n`,
  ),
  ply(`format binary_little_endian 1.0\nelement vertex 3\n${XYZ}\n${FACES}`, 'short'),
  ply(`format binary_big_endian 1.0\nelement vertex 3\n${XYZ}\n${FACES}`, ''),
];

const STL: [string, string][] = [
  ['a.stl', ''],
  ['a.stl', 'solid'],
  ['a.stl', 'solid a\nendsolid a\n'],
  [
    'a.stl',
    'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid\n',
  ],
  [
    'a.stl',
    'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex x 1 0\nendloop\nendfacet\nendsolid\n',
  ],
  ['a.stl', 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n'],
  ['a.stl', 'short'],
  ['a.stl', `${'\0'.repeat(80)}\u0005\0\0\0`],
  ['a.stl', '\0'.repeat(84)],
  ['a.stl', '\0'.repeat(60)],
];

const OFF: [string, string][] = [
  ['a.off', ''],
  ['a.off', 'OFF\n'],
  ['a.off', 'OFF\n3\n'],
  ['a.off', 'OFF\n3 1 0\n'],
  ['a.off', `OFF\n3 1 0\n${CORNERS}`],
  ['a.off', `OFF\n3 1 0\n${CORNERS}3 0 1\n`],
  ['a.off', `OFF\n3 1 0\n${CORNERS}3 0 1 3\n`],
  ['a.off', `OFF\n3 1 0\n${CORNERS}3 0 1 -1\n`],
  ['a.off', `OFF\n3 1 0\na b c\n1 0 0\n0 1 0\n3 0 1 2\n`],
  ['a.off', `OFF\n3 0 0\n${CORNERS}`],
  ['a.off', `OFF\n-3 1 0\n${CORNERS}`],
  ['a.off', `OFF\n1e12 1 0\n`],
  ['a.off', `OFF BINARY\n`],
  ['a.off', `XOFF\n3 1 0\n`],
  ['a.off', `4OFF\n3 1 0\n`],
];

const asset = { version: '2.0' };
const triangle = `data:application/octet-stream;base64,${btoa('\0'.repeat(36))}`;
const buffers = [{ uri: triangle, byteLength: 36 }];
const bufferViews = [{ buffer: 0, byteLength: 36 }];
const accessors = [
  { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [0, 0, 0] },
];
const meshes = [{ primitives: [{ attributes: { POSITION: 0 } }] }];
/** a file of one triangle */
const whole = {
  asset,
  buffers,
  bufferViews,
  accessors,
  meshes,
  nodes: [{ mesh: 0 }],
  scenes: [{ nodes: [0] }],
  scene: 0,
};

/** What of a file differs from one triangle's, where it has its other parts. */
function changeOf(json: object): string {
  const isChanged = Object.keys(whole).every((key) => key in json);
  const own = Object.entries(json).filter(([key, value]) => whole[key as keyof typeof whole] !== value);
  return isChanged ? `a triangle with ${JSON.stringify(Object.fromEntries(own))}` : JSON.stringify(json);
}

const GLTF: ModelFile[] = [
  ['a.gltf', ''],
  ['a.gltf', '{'],
  ['a.gltf', 'null'],
  ['a.gltf', '[]'],
  ['a.gltf', '5'],
  ['a.gltf', '"text"'],
  ...[
    {},
    { asset: 5 },
    { asset: {} },
    { asset: { version: 2 } },
    { asset: { version: '3.0' } },
    { asset: { version: '1.0' } },
    { asset },
    { asset, meshes: [] },
    { asset, meshes: {} },
    { asset, meshes: [null] },
    { asset, meshes: [{}] },
    { asset, meshes: [{ primitives: [] }] },
    { asset, meshes: [{ primitives: [{}] }] },
    { asset, meshes },
    { ...whole, accessors: [] },
    { ...whole, accessors: [{ ...accessors[0], count: 4 }] },
    { ...whole, accessors: [{ ...accessors[0], count: -1 }] },
    { ...whole, accessors: [{ ...accessors[0], count: 1.5 }] },
    { ...whole, accessors: [{ ...accessors[0], type: 'VEC9' }] },
    { ...whole, accessors: [{ ...accessors[0], componentType: 1 }] },
    { ...whole, accessors: [{ ...accessors[0], bufferView: 7 }] },
    { ...whole, accessors: [{ ...accessors[0], byteOffset: 8 }] },
    { ...whole, accessors: [{ ...accessors[0], type: 'SCALAR' }] },
    { ...whole, bufferViews: [] },
    { ...whole, bufferViews: [{ buffer: 3, byteLength: 36 }] },
    { ...whole, bufferViews: [{ buffer: 0, byteOffset: -4, byteLength: 36 }] },
    { ...whole, buffers: [] },
    { ...whole, buffers: [{ byteLength: 36 }] },
    { ...whole, buffers: [{ uri: 'gone.bin', byteLength: 36 }] },
    { ...whole, buffers: [{ uri: '../up.bin', byteLength: 36 }] },
    { ...whole, buffers: [{ uri: '/etc/hosts', byteLength: 36 }] },
    { ...whole, buffers: [{ uri: 'https://example.com/a.bin', byteLength: 36 }] },
    { ...whole, buffers: [{ uri: 'file:///a.bin', byteLength: 36 }] },
    { ...whole, buffers: [{ uri: 'data:application/octet-stream;base64,AAAA', byteLength: 36 }] },
    { ...whole, buffers: [{ uri: 'data:,', byteLength: 36 }] },
    { ...whole, buffers: [{ uri: 5, byteLength: 36 }] },
    { ...whole, nodes: [{ children: [0] }] },
    { ...whole, nodes: [{ children: [9] }] },
    { ...whole, scenes: [{ nodes: [4] }] },
    { ...whole, nodes: 'all' },
    { ...whole, meshes: [{ primitives: [{ attributes: {} }] }] },
    { ...whole, meshes: [{ primitives: [{ attributes: { POSITION: 9 } }] }] },
    { ...whole, meshes: [{ primitives: [{ attributes: { POSITION: 'a' } }] }] },
    { ...whole, meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 9 }] }] },
    { ...whole, meshes: [{ primitives: [{ attributes: { POSITION: 0 }, mode: 99 }] }] },
    { ...whole, meshes: [{ primitives: [{ attributes: { POSITION: 0 }, mode: 0 }] }] },
    { ...whole, extensionsUsed: ['X_unknown'], extensionsRequired: ['X_unknown'] },
    { ...whole, extensionsRequired: 'KHR_draco_mesh_compression' },
    ...[9, {}, 'a'].map((bufferView) => ({
      ...whole,
      meshes: [{ primitives: [{ extensions: { KHR_draco_mesh_compression: { bufferView } } }] }],
    })),
    { ...whole, skins: [{}], nodes: [{ mesh: 0, skin: 0 }] },
    { ...whole, animations: [{ channels: [{}], samplers: [] }] },
  ].map((json): ModelFile => ['a.gltf', JSON.stringify(json), changeOf(json)]),
];

const OTHERS: [string, string][] = [
  ['a.glb', ''],
  ['a.glb', 'glTF'],
  ['a.glb', 'glTF\u0002\0\0\0\u0014\0\0\0\0\0\0\0JSON'],
  ['a.glb', 'glTF\u0002\0\0\0\u00ff\0\0\0\u0004\0\0\0JSON{}  '],
  ['a.glb', 'glTF\u0003\0\0\0\u0014\0\0\0\0\0\0\0JSON'],
  ['a.glb', 'not a glb at all, but some words'],
  ['a.zip', ''],
  ['a.zip', 'PK\u0003\u0004'],
  ['a.zip', 'words'],
  ['a.zip', 'PK\u0005\u0006' + '\0'.repeat(18)],
  ['a.fbx', 'Kaydara FBX Binary  \0'],
  ['a.blend', 'BLENDER-v300'],
  ['a.usdz', 'PK\u0003\u0004'],
  ['a.usda', '#usda 1.0'],
  ['a.dae', '<COLLADA>'],
  ['a.3ds', 'MM'],
  ['a.abc', 'Ogawa'],
  ['a.vrm', ''],
  ['a.png', '\u0089PNG'],
  ['a.mtl', 'newmtl a'],
  ['a.txt', 'hello'],
  ['a', 'hello'],
  ['a.json', '{}'],
  ['a.bin', '\0\0\0'],
  ['a.max', 'x'],
  ['a.ma', '//Maya ASCII'],
  ['a.step', 'ISO-10303-21;'],
];

export const MODEL_FILES: readonly ModelFile[] = [...OBJ, ...PLY, ...STL, ...OFF, ...GLTF, ...OTHERS];
