import { defineConfig } from '@playwright/test';

const arguments_ = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
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
  timeout: 90_000,
  expect: { timeout: 20_000 },
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
