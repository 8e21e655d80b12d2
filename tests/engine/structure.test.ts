/** Tests the structure checks of `npm run lint`: each finds its kind of fault, and nothing if there is none. */

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { drawArchitecture } from '../../scripts/docs/architecture-picture.mjs';
import { wrongDependencies } from '../../scripts/structure/dependencies.mjs';
import { importCycles } from '../../scripts/structure/cycles.mjs';
import { missingPaths } from '../../scripts/structure/document_paths.mjs';
import { struckWords } from '../../scripts/structure/glossary.mjs';
import { modules } from '../../scripts/structure/modules.mjs';
import { largeThings, limits, percentile } from '../../scripts/structure/sizes.mjs';
import { blankComments, readProduct, wordsOf } from '../../scripts/structure/texts.mjs';
import { doubleTypeNames } from '../../scripts/structure/type_names.mjs';

const file = (path: string, text: string) => ({ path, text });
const lines = (count: number, line: string) => `${line}\n`.repeat(count);

describe('dependencies', () => {
  const house = {
    'wasm/base': [],
    'wasm/mesh': ['wasm/base'],
    'web/engine/core': [],
    'web/app': ['web/engine/core'],
  };

  test('an allowed include passes, one in the other direction is reported', () => {
    const base = file('wasm/base/job.h', '#include "mesh/topology.h"\n');
    const mesh = file('wasm/mesh/topology.h', '#include <vector>\n#include "base/job.h"\n');
    expect(wrongDependencies([mesh], house)).toEqual([]);
    expect(wrongDependencies([base, mesh], house)).toEqual([
      'wasm/base/job.h imports wasm/mesh/topology.h, but wasm/base must not depend on wasm/mesh.',
    ]);
  });

  test.each([
    ["import { page } from '../../app/page';"],
    ["import type { Page } from '../../app/page';"],
    ["export { page } from '../../app/page';"],
    ["const page = await import('../../app/page');"],
    ["type Page = import('../../app/page').Page;"],
  ])('an engine that knows the page is told: %s', (text) => {
    const page = file('web/app/page.tsx', "import { a } from '../engine/core/a';");
    const found = wrongDependencies([file('web/engine/core/a.ts', text), page], house);
    expect(found).toEqual([
      'web/engine/core/a.ts imports web/app/page.tsx, but web/engine/core must not depend on web/app.',
    ]);
  });

  test('a folder that is a module inside another module counts as its own module', () => {
    const house = { 'web/app': ['web/app/worker'], 'web/app/worker': [] };
    const worker = file('web/app/worker/worker.ts', "import '../app';");
    expect(
      wrongDependencies([worker, file('web/app/app.tsx', "import './worker/worker';")], house),
    ).toHaveLength(1);
  });

  test('code outside of all modules is reported', () => {
    expect(wrongDependencies([file('wasm/attic/box.h', '#pragma once\n')], house)).toEqual([
      'wasm/attic/box.h is in no module of scripts/structure/modules.mjs.',
    ]);
  });

  test('the modules have no cycles, and name only modules that exist', () => {
    const knows = (module: string, target: string, seen = new Set<string>()): boolean =>
      modules[module].some(
        (next) => next === target || (!seen.has(next) && knows(next, target, seen.add(next))),
      );
    // The page's root assembles the panels, and they use its other files.
    const inner = Object.keys(modules).filter(
      (module) => module !== 'web/app' && module !== 'web/app/panels',
    );
    expect(inner.filter((module) => knows(module, module))).toEqual([]);
    const known = Object.values(modules).flat();
    expect(known.filter((module) => !(module in modules))).toEqual([]);
  });
});

describe('cycles', () => {
  test('a header and a source that include each other through two files are reported', () => {
    const found = importCycles([
      file('wasm/mesh/charts.h', '#include "mesh/corners.h"\n'),
      file('wasm/mesh/corners.h', '#pragma once\n'),
      file('wasm/mesh/corners.cpp', '#include "mesh/corners.h"\n#include "mesh/charts.h"\n'),
    ]);
    expect(found).toEqual(['These 2 include each other in a cycle: wasm/mesh/charts, wasm/mesh/corners.']);
  });

  test('type imports count', () => {
    const one = file('web/engine/core/one.ts', "import type { Two } from './two';");
    const two = file('web/engine/core/two.ts', "import type { Three } from './three';");
    const three = file('web/engine/core/three.ts', "import type { One } from './one';");
    expect(importCycles([one, two, three])).toHaveLength(1);
    expect(importCycles([one, two])).toEqual([]);
  });
});

describe('sizes', () => {
  const named = (name: string, body: string, signature = `int ${name}(int a)`) =>
    `${signature} {\n${body}}\n`;

  test('a folder of 31 files is reported, one of 30 is not', () => {
    const folder = (count: number) =>
      Array.from({ length: count }, (_, i) => file(`wasm/mesh/a${i}.h`, '#pragma once\n'));
    expect(largeThings(folder(limits.filesOfFolder))).toEqual([]);
    expect(largeThings(folder(limits.filesOfFolder + 1))).toEqual([
      'wasm/mesh has 31 files directly inside (at most 30).',
    ]);
  });

  test('a file of 351 lines is reported, the table of settings is not', () => {
    const text = lines(limits.linesOfFile + 1, '// a comment');
    expect(largeThings([file('wasm/mesh/a.h', text)])).toEqual([
      'wasm/mesh/a.h has 351 lines (at most 350).',
    ]);
    expect(largeThings([file('web/engine/settings/table.ts', text)])).toEqual([]);
  });

  test('a C++ function of 61 lines is reported wherever its signature ends; comments do not count', () => {
    const split = 'Result Solver::solve(const Mesh& mesh,\n                     int b) const';
    const text = `namespace limber {\n${named('solve', lines(59, '  ++a;'), split)}}\n`;
    expect(largeThings([file('wasm/fit/a.cpp', text)])[0]).toBe(
      'wasm/fit/a.cpp:2 solve is 62 lines long (at most 60).',
    );
    expect(largeThings([file('wasm/fit/a.cpp', named('a', lines(70, '  // quiet')))])).toEqual([]);
  });

  test('a TypeScript function of 61 lines is reported, one of 60 is not', () => {
    const run = (count: number) => `export const run = () => {\n${lines(count - 2, '  step();')}};\n`;
    const told = 'web/cli/a.ts:1 run is 61 lines long (at most 60).';
    expect(largeThings([file('web/cli/a.ts', run(61))])).toContain(told);
    expect(largeThings([file('web/cli/a.ts', run(60))]).join()).not.toContain(' long ');
  });

  test('99 of 100 functions have to be short', () => {
    const functions = (count: number, length: number) =>
      Array.from({ length: count }, (_, i) => named(`f${i}`, lines(length - 2, '  ++a;'))).join('');
    const mixed = (long: number) => [
      file('wasm/fit/a.h', functions(long, 40)),
      file('wasm/fit/b.h', functions(100 - long, 3)),
    ];
    expect(largeThings(mixed(1)).join()).not.toContain('99 of 100');
    expect(largeThings(mixed(2)).join()).toContain(
      '99 of 100 functions of C++ have up to 40 lines (at most 35).',
    );
    expect(percentile([1, 2, 3, 4], 0.5)).toBe(2);
  });

  test.each([
    [
      'a hidden function',
      'namespace {\nint f(int a, Map<int, int> b, int (*c)(int, int), int d, int e) {\n}\n}',
      1,
    ],
    ['a member', 'int Solver::f(int a, int b, int c, int d, int e) const {\n}', 1],
    ['a constructor', 'Solver::Solver(int a, int b, int c, int d, int e) : a_{a}, b_(b) {\n}', 1],
    [
      'a template',
      'namespace {\ntemplate <typename A, typename B>\nvoid f(A a, B b, Map<A, B> c, int d, int e) {\n}\n}',
      1,
    ],
    ['an entry point with five', 'int f(int a, int b, int c, int d, int e) {\n}', 0],
    [
      'a call operator with four',
      'struct F {\nbool operator()(int a, int b, int c, Map<int, int> d) const {\n}\n};',
      0,
    ],
    ['a concept', 'template <class A>\nconcept C = requires(A a, A b, A c, A d, A e, A f) {\nf(a);\n};', 0],
    ['values in braces', 'const std::vector<Row> rows = {\n{f(1, 2, 3, 4, 5, 6)}, {g(1, 2)}};', 0],
  ])('parameters of C++: %s', (_, text, count) => {
    const header = file('wasm/fit/a.h', 'int f(int a, int b, int c, int d, int e);\n');
    expect(largeThings([header, file('wasm/fit/a.cpp', text)])).toHaveLength(count);
  });

  test('a TypeScript function may have five parameters only if it is exported', () => {
    const text = 'function f(a, b, c, d, e) {}\n';
    expect(largeThings([file('web/cli/a.ts', text)])).toEqual([
      'web/cli/a.ts:1 f has 5 parameters (at most 4).',
    ]);
    expect(largeThings([file('web/cli/a.ts', `export ${text}`)])).toEqual([]);
    expect(largeThings([file('web/cli/a.ts', 'export const f = (a, b, c, d, e, g) => 0;')])).toHaveLength(1);
  });
});

describe('type names', () => {
  const header = (text: string) => `namespace limber {\n${text}\n}  // namespace limber\n`;

  test('a class in two headers is reported, even if one of them is hidden', () => {
    const one = file('wasm/base/sets.h', header('class Sets {\n int a;\n};'));
    const two = file('wasm/fit/pieces.cpp', header('namespace {\nstruct Sets {\n};\n}'));
    expect(doubleTypeNames([one, two])).toEqual([
      'The type limber::Sets is defined in wasm/base/sets.h and wasm/fit/pieces.cpp.',
    ]);
  });

  test('declarations, members of different classes and other namespaces are not reported', () => {
    const files = [
      file('wasm/base/a.h', header('class A;\nstruct B {\n struct Part {\n };\n};')),
      file('wasm/base/b.h', header('struct A {\n struct Part {\n };\n};')),
      file('wasm/base/c.cpp', header('struct A::Inner {\n};\nnamespace dense {\nstruct B {\n};\n}')),
    ];
    expect(doubleTypeNames(files)).toEqual([]);
  });

  test('types that two files of the engine export are reported, types of page and engine are not', () => {
    const text = 'export interface Body { a: number }\n';
    const one = file('web/engine/body/body.ts', text);
    expect(doubleTypeNames([one, file('web/engine/core/body.ts', 'export type Body = 1;')])).toHaveLength(1);
    expect(
      doubleTypeNames([one, file('web/app/body.ts', text), file('web/engine/core/b.ts', 'type Body = 1;')]),
    ).toEqual([]);
  });
});

describe('glossary', () => {
  const glossary = [
    '| term | meaning | instead of |',
    '| ---- | ------- | ---------- |',
    '| pinned | held in place | hold, holds |',
    '| feature edge | an edge | `Lines` |',
    '| part | | piece of a body |',
    '',
    '| measure | found |',
    '| ------- | ----- |',
    '| time | piece |',
  ].join('\n');
  const struck = (path: string, text: string) => struckWords([file(path, text)], glossary);

  test('a struck word is reported as a whole name and as part of one', () => {
    expect(struck('wasm/fit/a.h', 'int firstHold_ = 1;')).toEqual([
      'wasm/fit/a.h has names that docs/glossary.md strikes: firstHold_ ("hold": say pinned).',
    ]);
    expect(struck('wasm/fit/a.h', 'int kHOLDS, threshold;')).toHaveLength(1);
    expect(struck('web/app/a.tsx', 'export const A = () => <B hold={1} />;')).toHaveLength(1);
    expect(struck('wasm/fit/hold_down.h', '')).toHaveLength(1);
  });

  test('comments, texts, longer words and terms of several words are not reported', () => {
    const quiet =
      '// hold\n/* holds */ const char* a = "hold"; int threshold = 1\'000, piece, line; // "hold"\n';
    expect(struck('wasm/fit/a.h', quiet)).toEqual([]);
    expect(
      struck('web/app/a.tsx', 'export const A = () => <p title="hold">hold `hold` {`hold`}</p>; // hold'),
    ).toEqual([]);
  });

  test('a name in backticks is reported only as a whole name', () => {
    expect(struck('wasm/fit/a.h', 'Lines a;')).toHaveLength(1);
    expect(struck('wasm/fit/a.h', 'int lines, featureLines;')).toEqual([]);
  });
});

describe('paths in documents', () => {
  const known = new Set(['wasm/mesh/repair/weld.cpp', 'docs/modes.md', 'README.md']);
  const missing = (path: string, text: string) => missingPaths([file(path, text)], known);

  test('a missing file is reported, in code and as the target of a link', () => {
    expect(missing('README.md', 'See `wasm/mesh/wold.cpp: weld`.')).toEqual([
      'README.md names wasm/mesh/wold.cpp, which is not there.',
    ]);
    expect(missing('docs/a.md', '[modes](modes.md#pins), [a](../wasm/a.h)')).toHaveLength(1);
  });

  test('existing files, folders and patterns pass, as do addresses and examples', () => {
    const text =
      '`wasm/mesh/repair/weld.cpp: weld`, `wasm/mesh/`, `wasm/fit/*.h`, `tests/core/NAME_test.cpp`, [b](https://b.de)';
    expect(missing('README.md', `${text}\n\`\`\`\n\`wasm/none.h\`\n\`\`\`\n`)).toEqual([]);
  });
});

test('names are split into words at capitals, underscores and dots', () => {
  expect(wordsOf('readGLTFFile_2')).toEqual(['read', 'gltf', 'file', '2']);
  expect(wordsOf('kd_tree.test.h')).toEqual(['kd', 'tree', 'test', 'h']);
});

test('blanked text keeps its lines and its code', () => {
  const text = "int a = 20'000; // 'x'\nauto b = R\"(})\"; char c = '{', d = '\\''; /*\n{ */ int e;\n";
  const blanked = blankComments(text);
  expect(blanked.length).toBe(text.length);
  expect(blanked).not.toMatch(/[{}]/);
  expect(blanked).toContain("20'000");
  expect(blanked.split('\n')[2]).toContain('int e;');
});

test('the checks read the whole product', () => {
  const paths = readProduct().map(({ path }) => path);
  expect(paths).toContain('wasm/simplify/simplify.cpp');
  expect(paths.some((path) => path.startsWith('web/app/panels/'))).toBe(true);
});

test('the picture of the architecture agrees with the modules', () => {
  const picture = join(import.meta.dirname, '..', '..', 'docs', 'images', 'architecture.svg');
  expect(readFileSync(picture, 'utf8'), 'run node scripts/docs/architecture-picture.mjs').toBe(
    drawArchitecture(),
  );
});
