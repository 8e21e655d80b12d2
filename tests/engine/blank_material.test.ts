import * as THREE from 'three';
import { expect, test } from 'vitest';
import { isBlankMaterial } from '../../web/app/viewer/file/blank_material';

const made = (change: THREE.MeshStandardMaterialParameters = {}) =>
  new THREE.MeshStandardMaterial({ roughness: 1, ...change });

test('a material with nothing but a name is blank', () => {
  expect(isBlankMaterial(made())).toBe(true);
  expect(isBlankMaterial(made({ name: 'Leather', metalness: 1, side: THREE.DoubleSide }))).toBe(true);
});

test('a material with any property of its appearance is not blank', () => {
  const said: THREE.MeshStandardMaterialParameters[] = [
    { color: '#fefefe' },
    { emissive: '#010101' },
    { roughness: 0.9 },
    { opacity: 0.5 },
    { vertexColors: true },
    { map: new THREE.Texture() },
    { normalMap: new THREE.Texture() },
  ];
  for (const change of said) expect(isBlankMaterial(made(change))).toBe(false);
  expect(isBlankMaterial(new THREE.MeshPhysicalMaterial({ roughness: 1 }))).toBe(false);
  expect(isBlankMaterial(new THREE.MeshBasicMaterial())).toBe(false);
});
