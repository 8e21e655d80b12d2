// The architecture's arrows, read from every #include and import: a layer may only know the layers it points to.

import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { root } from './setup/environment.mjs';

const core = {
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
  compare: ['base', 'mesh', 'query', 'elastic', 'simulate', 'transfer'],
  fit: ['base', 'mesh', 'linear', 'query', 'elastic', 'simplify', 'transfer', 'modes', 'compare'],
};
const web = { engine: [], app: ['engine'], cli: ['engine'] };

function filesBelow(folder, endings) {
  return readdirSync(join(root, folder), { recursive: true })
    .map((name) => join(folder, name))
    .filter((name) => endings.some((ending) => name.endsWith(ending)));
}

function coreViolations() {
  return filesBelow('wasm', ['.h', '.cpp']).flatMap((file) => {
    const layer = file.split('/')[1];
    if (!(layer in core)) return []; // wasm/bind/bindings.cpp knows everything
    const includes = [...readFileSync(join(root, file), 'utf8').matchAll(/#include "([a-z_]+)\//g)];
    return includes
      .map((match) => match[1])
      .filter((target) => target !== layer && !core[layer].includes(target))
      .map((target) => `${file} includes ${target}/, which ${layer} must not know.`);
  });
}

function webViolations() {
  return filesBelow('web', ['.ts', '.tsx']).flatMap((file) => {
    const layer = file.split('/')[1];
    const imports = [...readFileSync(join(root, file), 'utf8').matchAll(/(?:from|import\()\s*'(\.[^']+)'/g)];
    return imports
      .map((match) => relative(join(root, 'web'), resolve(root, dirname(file), match[1])).split('/')[0])
      .filter((target) => target in web && target !== layer && !web[layer].includes(target))
      .map((target) => `${file} imports ${target}/, which ${layer} must not know.`);
  });
}

/** Every import or include that goes against an arrow, a sentence each. */
export const layerViolations = () => [...coreViolations(), ...webViolations()];
