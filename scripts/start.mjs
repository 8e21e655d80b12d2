// npm start: sets up, builds what is out of date, serves the app and prints its address.

import { availableParallelism } from 'node:os';

const USAGE = `Usage: npm start

Sets up what is missing, builds what is out of date, serves the app and prints its address. Ctrl+C ends it.

Environment:
  PORT  the port, or the next one that is free (default: 4173)
  HOST  the address to serve at, for other machines too (default: localhost); the core without threads is then built as well
`;

/** The text to print instead of starting, and the exit code; null: start. */
function answerTo(words) {
  if (words.includes('--help') || words.includes('-h')) return { text: USAGE, code: 0 };
  if (words.length === 0) return null;
  const text = `"${words[0]}" is not known: npm start takes no flag but --help, and PORT and HOST from the environment.\n`;
  return { text, code: 2 };
}

async function start() {
  const { build } = await import('./build.mjs');
  // Without HTTPS, browsers only let pages from localhost share memory between threads; other hosts need the core
  // without threads.
  build({ threadsOnly: process.env.HOST === undefined && availableParallelism() > 1 });
  const { preview } = await import('vite');
  const port = Number(process.env.PORT ?? 4173);
  const server = await preview({
    preview: { port, strictPort: false, host: process.env.HOST ?? 'localhost' },
    logLevel: 'warn',
  });
  console.log(
    `Limber is at ${server.resolvedUrls?.local[0] ?? `http://localhost:${port}/`}  (Ctrl+C ends it)`,
  );
}

const answer = answerTo(process.argv.slice(2));
if (answer === null) await start();
else {
  (answer.code === 0 ? process.stdout : process.stderr).write(answer.text);
  process.exitCode = answer.code;
}
