// npm start: sets up, builds what is out of date, serves the app and prints its address.

import { availableParallelism } from 'node:os';
import { build } from './build.mjs';

// Without HTTPS browsers let pages share memory between threads only from localhost; others need the core without threads.
build({ threadsOnly: process.env.HOST === undefined && availableParallelism() > 1 });
const { preview } = await import('vite');
const port = Number(process.env.PORT ?? 4173);
const server = await preview({
  preview: { port, strictPort: false, host: process.env.HOST ?? 'localhost' },
  logLevel: 'warn',
});
console.log(`Limber is at ${server.resolvedUrls?.local[0] ?? `http://localhost:${port}/`}  (Ctrl+C ends it)`);
