import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { defineConfig } from '@playwright/test';

const shared = join(import.meta.dirname, 'tests', 'browser-arguments.json');
const arguments_ = [
  ...(JSON.parse(readFileSync(shared, 'utf8')) as string[]),
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];

// The built page, served twice: as `npm start` does, and by a plain host that sends no isolation headers.
export const ISOLATED = 'http://localhost:4273/';
export const PLAIN = 'http://localhost:4274/';

export default defineConfig({
  testDir: 'tests/app',
  outputDir: 'build/results/playwright',
  workers: 1,
  // They end a test that hangs; on a slow machine a step may take several times what it takes elsewhere.
  timeout: 240_000,
  expect: { timeout: 100_000 },
  use: {
    baseURL: ISOLATED,
    viewport: { width: 1280, height: 800 },
    launchOptions: { executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: arguments_ },
  },
  webServer: [
    { command: 'node node_modules/vite/bin/vite.js preview --port 4273 --strictPort', url: ISOLATED },
    { command: 'node tests/app/plain-server.mjs 4274', url: PLAIN },
  ],
});
