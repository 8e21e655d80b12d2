/** The dark or the light colour scheme: that of the system unless the user has chosen one. */

import { computed, signal } from '@preact/signals';
import { view } from './store';

const query = matchMedia('(prefers-color-scheme: dark)');
const systemIsDark = signal(query.matches);
query.addEventListener('change', () => (systemIsDark.value = query.matches));

export const isDark = computed(() =>
  view.theme.value === 'system' ? systemIsDark.value : view.theme.value === 'dark',
);

/** Whether the system currently asks for reduced motion. */
export const isMotionReduced = (): boolean => matchMedia('(prefers-reduced-motion: reduce)').matches;

/** The colours of the viewport; those of the page itself are in styles/tokens.css. */
export const LIGHT = {
  clay: '#b9c8d4',
  wire: '#1c2a36',
  pin: { fill: '#e8590c', rim: '#ffffff' },
  overlay: '#e8590c',
  collisionScene: { floor: '#c3ccd4', line: '#8d9aa6', body: '#d9b98c' },
};

const DARK: typeof LIGHT = {
  clay: '#93a9bb',
  wire: '#0b1016',
  pin: { fill: '#ff9d5c', rim: '#1a0d04' },
  overlay: '#ff9d5c',
  collisionScene: { floor: '#2b3541', line: '#4a5866', body: '#a8875b' },
};

export const viewportColours = computed(() => (isDark.value ? DARK : LIGHT));
