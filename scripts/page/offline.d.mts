import type { Plugin } from 'vite';

export function offline(): Plugin;
export function buildServiceWorker(folder: string): Promise<void>;
