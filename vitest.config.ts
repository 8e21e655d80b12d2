import { defineConfig } from 'vitest/config';

// The engine, the command line and the npm package, against the real wasm.
export default defineConfig({
  test: {
    include: ['tests/engine/**/*.test.ts', 'tests/library/**/*.test.ts', 'tests/fuzz/**/*.test.ts'],
    environment: 'node',
    testTimeout: 120_000,
    hookTimeout: 120_000,
    // Each file may start a pool of threads of its own.
    maxWorkers: 2,
    // Its build for Node has no named exports.
    server: { deps: { inline: ['gifenc'] } },
  },
});
