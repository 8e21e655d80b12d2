// Formats the C++ sources in place.

import { coreFiles } from './check.mjs';
import { findClangFormat, root, run } from './setup/environment.mjs';

run(findClangFormat() ?? 'clang-format', ['-i', ...coreFiles()], { cwd: root });
