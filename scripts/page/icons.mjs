// Draws public/icon.svg as the PNG files that the manifest lists. Usage: node scripts/page/icons.mjs (needs Chromium).

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { findChromium, root } from '../setup/environment.mjs';

const svg = readFileSync(join(root, 'public', 'icon.svg'), 'utf8');
const browser = await chromium.launch({ executablePath: findChromium() });
for (const size of [192, 512]) {
  const page = await browser.newPage({ viewport: { width: size, height: size } });
  // A maskable icon has square corners: the system crops them.
  await page.setContent(`<body style="margin:0;background:#1c3768">${svg}`);
  await page.screenshot({ path: join(root, 'public', `icon-${size}.png`) });
}
await browser.close();
