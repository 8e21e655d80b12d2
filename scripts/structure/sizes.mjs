// Limits on the size of folders, files and functions of the product.

import { dirname } from 'node:path/posix';
import { cppFunctions } from './cpp_functions.mjs';
import { isCore } from './texts.mjs';
import { tsFunctions } from './ts_functions.mjs';

export const limits = {
  filesOfFolder: 30,
  linesOfFile: 350,
  linesOfFunction: 60,
  linesOfMost: 35, // for 99 of 100 functions
  parameters: 4,
  parametersOfEntryPoint: 5, // for a function that its module exports
};

/** Files that may be longer, and why. */
export const longFiles = {
  'web/engine/settings/table.ts':
    'one row for each setting: a table is read by looking up, and is best in one place',
};

/** { folder: number of files directly in it }. */
export function folderSizes(files) {
  const counts = {};
  for (const { path } of files) counts[dirname(path)] = (counts[dirname(path)] ?? 0) + 1;
  return counts;
}

/** The number of lines of a text, without the empty one after the last line break. */
export const lineCount = (text) => text.replace(/\n$/, '').split('\n').length;

/** All functions in C++ and in TypeScript: { core: [...], web: [...] }. */
export function functionsOf(files) {
  const texts = new Map(files.map(({ path, text }) => [path, text]));
  const code = files.filter(({ text }) => text);
  return {
    core: code
      .filter(({ path }) => isCore(path))
      .flatMap((file) => cppFunctions(file, texts.get(file.path.replace(/\.cpp$/, '.h')))),
    web: code.filter(({ path }) => !isCore(path)).flatMap(tsFunctions),
  };
}

/** The smallest number that at least the share `part` of `values` does not exceed. */
export function percentile(values, part) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.max(0, Math.ceil(part * sorted.length) - 1)] ?? 0;
}

function largeFunctions(functions, language) {
  const large = functions.flatMap(({ path, line, name, length, parameters, isExported, isExcused }) => {
    const most = isExported ? limits.parametersOfEntryPoint : limits.parameters;
    return [
      ...(length > limits.linesOfFunction && !isExcused
        ? [`${path}:${line} ${name} is ${length} lines long (at most ${limits.linesOfFunction}).`]
        : []),
      ...(parameters > most
        ? [`${path}:${line} ${name} has ${parameters} parameters (at most ${most}).`]
        : []),
    ];
  });
  const most = percentile(
    functions.map(({ length }) => length),
    0.99,
  );
  const tail = `99 of 100 functions of ${language} have up to ${most} lines (at most ${limits.linesOfMost}).`;
  return most > limits.linesOfMost ? [...large, tail] : large;
}

/** One sentence for everything that is too large. */
export function largeThings(files) {
  const folders = Object.entries(folderSizes(files))
    .filter(([, count]) => count > limits.filesOfFolder)
    .map(
      ([folder, count]) => `${folder} has ${count} files directly inside (at most ${limits.filesOfFolder}).`,
    );
  const long = files
    .filter(({ path, text }) => lineCount(text) > limits.linesOfFile && !longFiles[path])
    .map(({ path, text }) => `${path} has ${lineCount(text)} lines (at most ${limits.linesOfFile}).`);
  const { core, web } = functionsOf(files);
  return [...folders, ...long, ...largeFunctions(core, 'C++'), ...largeFunctions(web, 'TypeScript')];
}
