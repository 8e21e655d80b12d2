import { existsSync } from 'node:fs';
import { basename, join } from 'node:path';
import { expect, test } from '@playwright/test';
import { validateBytes } from 'gltf-validator';
import { commandLineBytes, drop, goTo, openPage, readout, saveGlb } from './page';

const root = join(import.meta.dirname, '..', '..');
const shared = join(process.env.LIMBER_SHARED ?? join(root, '..', 'shared'), 'meshes');
const meshes = [
  'derived_eiffel_6156.obj',
  'spot_uv.obj',
  'skirt_4k.obj',
  'pyramid_frame_genus4.obj',
  'gltf/derived_spot.glb',
];

for (const name of meshes)
  test(
    `${basename(name)} goes through the page as through the command line`,
    { tag: name === meshes[0] ? [] : '@full' },
    async ({ page }) => {
      const path = join(shared, name);
      test.skip(!existsSync(path), `${name} of ../shared/meshes is not here`);
      await openPage(page);
      await drop(page, path);
      await expect(page.locator('.filename')).toHaveText(basename(name));
      await goTo(page, 'Reduce');
      await expect(readout(page, 'Topology')).toContainText('kept');
      const half = await page.getByLabel('Kept faces, exact').inputValue();
      const bytes = await saveGlb(page);
      expect((await validateBytes(bytes)).issues.numErrors).toBe(0);
      expect(Buffer.from(bytes).equals(commandLineBytes(path, ['--faces', half]))).toBe(true);
    },
  );
