// The modules (folders) of the product and their dependencies: each module lists the modules that it may use.

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
  compare: ['base', 'mesh', 'linear', 'query', 'elastic', 'simplify', 'simulate', 'transfer', 'modes'],
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

const below = (folder, modules) =>
  Object.fromEntries(
    Object.entries(modules).map(([module, known]) => [
      `${folder}/${module}`,
      known.map((name) => `${folder}/${name}`),
    ]),
  );

const engineModules = Object.keys(engine).map((module) => `web/engine/${module}`);
const appModules = Object.entries(app).map(([module, known]) => [
  `web/app/${module}`,
  [...engineModules, ...known.map((name) => `web/app/${name}`), ...(module === 'panels' ? ['web/app'] : [])],
]);

const libraryModules = Object.entries(library).map(([module, known]) => [
  `web/library/${module}`,
  [...engineModules, ...known.map((name) => `web/library/${name}`)],
]);

/** Module -> modules that it may use. A module is one file, or a folder with everything below it that is in no other module. */
export const modules = {
  ...below('wasm', { ...core, bind: Object.keys(core) }),
  ...below('web/engine', engine),
  ...Object.fromEntries(appModules),
  'web/app': [...engineModules, ...Object.keys(app).map((module) => `web/app/${module}`)],
  ...Object.fromEntries(libraryModules),
  'web/library': [...engineModules, 'web/library/options.ts', 'web/library/protocol.ts'],
  'web/cli': engineModules,
  'web/service_worker': [],
  'web/site': ['web/app/viewer'],
};
