// Builds the C++ core: as wasm for the product, with and without threads, and natively for tests and benchmarks.

import { copyFileSync, existsSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { findGoogleTest, folders, outputOf, root, run } from './environment.mjs';

/**
 * The command that starts a build so that its compilers always get the same addresses: LLVM before version 23 orders
 * the handlers of exceptions by the addresses of their blocks (llvm/llvm-project issue 204883), so that each build
 * would give different bytes. Empty if the system does not allow it.
 */
const FIXED_ADDRESSES = outputOf('setarch', '-R', 'true') === null ? [] : ['setarch', '-R'];

/** Configures a preset once and builds `targets`. `quiet` shows the compiler's output only if it fails. */
export function buildPreset(preset, targets, { emscripten, headers, compiler, quiet = true }) {
  const folder = join(folders.build, preset);
  if (!existsSync(join(folder, 'build.ninja'))) {
    const args = ['--preset', preset, `-DLIMBER_HEADERS=${headers}`];
    if (emscripten)
      args.push(
        `-DCMAKE_TOOLCHAIN_FILE=${join(emscripten, 'cmake', 'Modules', 'Platform', 'Emscripten.cmake')}`,
      );
    if (compiler) args.push(`-DCMAKE_CXX_COMPILER=${compiler}`);
    const tests = findGoogleTest();
    args.push(tests ? `-DGOOGLETEST_SOURCE=${tests}` : '-DLIMBER_TESTS=OFF');
    run('cmake', args, { quiet });
  }
  const [command, ...args] = [...FIXED_ADDRESSES, 'ninja', '-C', folder, ...targets];
  run(command, args, { quiet });
}

/** The wasm builds of the product: with and without threads. */
const WASM_BUILDS = ['threads', 'single'];

/** Builds the product's wasm into public/wasm/, both builds or the named ones. */
export function buildWasm(setup, builds = WASM_BUILDS) {
  const target = join(root, 'public', 'wasm');
  mkdirSync(target, { recursive: true });
  for (const preset of builds) {
    buildPreset(preset, ['limber'], setup);
    const name = `limber-${preset}`;
    copyFileSync(join(folders.build, preset, `${name}.wasm`), join(target, `${name}.wasm`));
    // Emscripten itself shortens names only where its Closure compiler is installed.
    const minify = join(root, 'scripts', 'setup', 'minify.mjs');
    run(process.execPath, [minify, join(folders.build, preset, `${name}.js`), join(target, `${name}.js`)]);
  }
}
