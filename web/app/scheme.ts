/** Dark or light: the system's wish unless the user has one. */

import { computed, signal } from '@preact/signals';
import { view } from './state/store';

const query = matchMedia('(prefers-color-scheme: dark)');
const systemIsDark = signal(query.matches);
query.addEventListener('change', () => (systemIsDark.value = query.matches));

export const isDark = computed(() =>
  view.theme.value === 'system' ? systemIsDark.value : view.theme.value === 'dark',
);
