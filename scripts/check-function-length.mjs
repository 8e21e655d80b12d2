// No C++ function over 60 lines without a comment that says why ("Long because ..."); eslint does the same for TypeScript.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './setup/environment.mjs';

const limit = 60;

/** Functions of `files` that are too long, a sentence each. Reads clang-format's layout: a body ends at its own indent. */
export function longFunctions(files) {
  return files
    .filter((file) => file.startsWith('wasm/'))
    .flatMap((file) => {
      const lines = readFileSync(join(root, file), 'utf8').split('\n');
      return lines.flatMap((line, start) => {
        if (!startsFunction(line)) return [];
        // The last of several initialisers of a constructor stands six columns in.
        const indent = /^ */.exec(line)[0].slice(/^ +\w+_\(/.test(line) ? 6 : 0);
        const length = lines.slice(start).findIndex((other) => other.startsWith(`${indent}}`));
        const reason = lines
          .slice(Math.max(0, start - 8), start)
          .some((other) => other.includes('Long because'));
        return length > limit && !reason
          ? [`${file}:${start + 1} is ${length} lines long (at most ${limit}).`]
          : [];
      });
    });
}

function startsFunction(line) {
  const isBlock = /^ *(namespace|struct|class|enum|union|for|while|if|else|switch|do|extern)\b|^ *:/.test(
    line,
  );
  return line.endsWith('{') && !isBlock && /\)( const| noexcept| override)*( -> [\w:<>]+)? \{$/.test(line);
}
