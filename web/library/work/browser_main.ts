/** The worker in browsers. */

import type { WorkRequest } from '../protocol';
import { Server } from './serve';

const server = new Server((message) => postMessage(message));
addEventListener('message', ({ data }: MessageEvent<WorkRequest>) => void server.answer(data));
