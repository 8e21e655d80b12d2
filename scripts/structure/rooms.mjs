// The rooms (folders) of the product and the arrows between them: each room lists the rooms that it may use.

/** Folders of wasm; `bind`, which connects the core to JavaScript, may use all of them. */
export const core = {
  base: [],
  mesh: ['base'],
  linear: ['base'],
  query: ['base', 'mesh'],
  elastic: ['base', 'mesh', 'linear'],
  fields: ['base', 'mesh'],
  simplify: ['base', 'mesh', 'query'],
  simulate: ['base', 'mesh', 'elastic'],
  transfer: ['base', 'mesh', 'query', 'simplify', 'simulate'],
  modes: ['base', 'mesh', 'linear', 'query', 'elastic', 'simplify'],
  compare: ['base', 'mesh', 'linear', 'query', 'elastic', 'simulate', 'transfer'],
  fit: ['base', 'mesh', 'linear', 'query', 'elastic', 'simplify', 'simulate', 'transfer', 'modes', 'compare'],
};

/** Folders of web/engine; a folder may use only those listed above it. */
export const engine = {
  core: [],
  document: ['core'],
  solvers: ['core'],
  settings: ['core', 'solvers'],
  body: ['core', 'document', 'settings'],
  report: ['core', 'document', 'solvers', 'settings', 'body'],
  motion: ['core', 'document', 'solvers', 'settings', 'body'],
  stages: ['core', 'document', 'solvers', 'settings', 'body', 'report', 'motion'],
};

/** Folders of web/app; the files next to them, which assemble the page, may use all of them. */
export const app = {
  language: [],
  'stroke.ts': [],
  worker: [],
  viewer: ['stroke.ts'],
  state: ['language', 'worker', 'stroke.ts'],
  controls: ['language', 'viewer', 'state'],
  files: ['language', 'state'],
  panels: ['language', 'worker', 'viewer', 'state', 'controls', 'files', 'stroke.ts'],
};

/** Folders of web/library; the files next to `work`, which the caller loads, know its messages only. */
export const library = {
  'options.ts': [],
  'protocol.ts': ['options.ts'],
  work: ['options.ts', 'protocol.ts'],
};

const below = (folder, rooms) =>
  Object.fromEntries(
    Object.entries(rooms).map(([room, known]) => [
      `${folder}/${room}`,
      known.map((name) => `${folder}/${name}`),
    ]),
  );

const engineRooms = Object.keys(engine).map((room) => `web/engine/${room}`);
const appRooms = Object.entries(app).map(([room, known]) => [
  `web/app/${room}`,
  [...engineRooms, ...known.map((name) => `web/app/${name}`), ...(room === 'panels' ? ['web/app'] : [])],
]);

const libraryRooms = Object.entries(library).map(([room, known]) => [
  `web/library/${room}`,
  [...engineRooms, ...known.map((name) => `web/library/${name}`)],
]);

/** Room -> rooms that it may use. A room is one file, or a folder with everything below it that is in no other room. */
export const rooms = {
  ...below('wasm', { ...core, bind: Object.keys(core) }),
  ...below('web/engine', engine),
  ...Object.fromEntries(appRooms),
  'web/app': [...engineRooms, ...Object.keys(app).map((room) => `web/app/${room}`)],
  ...Object.fromEntries(libraryRooms),
  'web/library': [...engineRooms, 'web/library/options.ts', 'web/library/protocol.ts'],
  'web/cli': engineRooms,
  'web/service_worker': [],
  'web/site': ['web/app/viewer'],
};
