/** The worker in Node. */

import { parentPort } from 'node:worker_threads';
import type { WorkRequest } from '../protocol';
import { Server } from './serve';

const port = parentPort!;
const server = new Server((message) => port.postMessage(message));
port.on('message', (request: WorkRequest) => void server.answer(request));
