// Every include and import must be a dependency that modules.mjs allows.

import { importEdges } from './imports.mjs';

/** The module of a path: the longest module name that contains the path; undefined if none does. */
export const moduleOf = (path, modules) =>
  Object.keys(modules)
    .filter((module) => path === module || path.startsWith(`${module}/`))
    .sort((a, b) => b.length - a.length)[0];

/** One sentence for every include or import that is not allowed, and for every file outside of the modules. */
export function wrongDependencies(files, modules) {
  const code = files.filter(({ text }) => text);
  const outside = code
    .filter(({ path }) => !moduleOf(path, modules))
    .map(({ path }) => `${path} is in no module of scripts/structure/modules.mjs.`);
  const wrong = importEdges(code).flatMap(({ from, to }) => {
    const [module, target] = [moduleOf(from, modules), moduleOf(to, modules)];
    const isAllowed = !module || !target || module === target || modules[module].includes(target);
    return isAllowed ? [] : [`${from} imports ${to}, but ${module} must not depend on ${target}.`];
  });
  return [...outside, ...wrong];
}
