/** The worker in browsers. */

import type { WorkRequest } from '../protocol';
import { Server } from './serve';

const server = new Server((message) => postMessage(message));
addEventListener('message', ({ data }: MessageEvent<WorkRequest>) => void server.answer(data));
// The core is started by callbacks; in Node such an error ends the worker by itself.
addEventListener('unhandledrejection', ({ reason }) => server.fail(reason));
