/** Thickness of materials (KHR_materials_volume): a length in units of the mesh, which quantizing changes. */

import { KHRMaterialsVolume } from '@gltf-transform/extensions';
import type { Document, Material, Mesh, Primitive } from '@gltf-transform/core';
import type { MappingList, Volume } from '@gltf-transform/extensions';
import { disposeOrphans } from '../prune';

const VOLUME = 'KHR_materials_volume';
const VARIANTS = 'KHR_materials_variants';

const volumeOf = (material: Material | null): Volume | null => material?.getExtension<Volume>(VOLUME) ?? null;
const isThick = (material: Material | null): material is Material =>
  (volumeOf(material)?.getThicknessFactor() ?? 0) > 0;
const variantsOf = (primitive: Primitive): MappingList | null =>
  primitive.getExtension<MappingList>(VARIANTS);

/** The materials of a primitive, by default and in variants. */
const materialsOf = (primitive: Primitive): (Material | null)[] => [
  primitive.getMaterial(),
  ...(variantsOf(primitive)?.listMappings() ?? []).map((mapping) => mapping.getMaterial()),
];

/**
 * To be called before quantizing; the function that it returns then gives all thick materials of a mesh its new units, in one copy of
 * each for the mesh. By itself, glTF-Transform makes a copy for every primitive, and forgets the materials of variants.
 */
export function followThickness(document: Document): () => void {
  const thick = document
    .getRoot()
    .listMeshes()
    .filter((mesh) => mesh.listPrimitives().some((primitive) => materialsOf(primitive).some(isThick)));
  const putAll = thick.map((mesh) => {
    const putBack = detachThickMaterials(mesh);
    const endProbe = addProbe(document, mesh);
    return () => {
      const scale = endProbe();
      putBack();
      scaleThickness(mesh, scale);
    };
  });
  return () => {
    for (const put of putAll) put();
    for (const extension of document.getRoot().listExtensionsUsed())
      if (extension.extensionName === VARIANTS) disposeOrphans(extension);
  };
}

/** Removes thick materials from the primitives; the returned function puts them back. */
function detachThickMaterials(mesh: Mesh): () => void {
  const taken = mesh.listPrimitives().flatMap((primitive) => {
    const material = primitive.getMaterial();
    return isThick(material) ? [{ primitive, material }] : [];
  });
  for (const { primitive } of taken) primitive.setMaterial(null);
  return () => taken.forEach(({ primitive, material }) => primitive.setMaterial(material));
}

/** Adds a vertex with a material of thickness 1 to the mesh; the returned function removes it and returns the thickness after quantizing. */
function addProbe(document: Document, mesh: Mesh): () => number {
  const positions = mesh.listPrimitives()[0].getAttribute('POSITION')!;
  const vertex = document
    .createAccessor('', positions.getBuffer())
    .setType('VEC3')
    .setArray(Float32Array.from(positions.getElement(0, [])));
  const volume = document.createExtension(KHRMaterialsVolume).createVolume().setThicknessFactor(1);
  const material = document.createMaterial().setExtension(VOLUME, volume);
  const probe = document.createPrimitive().setAttribute('POSITION', vertex).setMaterial(material);
  mesh.addPrimitive(probe);
  return () => {
    const [found, vertices] = [probe.getMaterial()!, probe.getAttribute('POSITION')!];
    const scale = volumeOf(found)!.getThicknessFactor();
    for (const one of [volumeOf(found)!, volume, found, material, vertices, vertex, probe]) one.dispose();
    return scale;
  };
}

function scaleThickness(mesh: Mesh, scale: number): void {
  const copies = new Map<Material, Material>();
  const scaled = (material: Material): Material => {
    if (!copies.has(material)) copies.set(material, scaledCopy(material, scale));
    return copies.get(material)!;
  };
  for (const primitive of mesh.listPrimitives()) {
    const material = primitive.getMaterial();
    if (isThick(material)) primitive.setMaterial(scaled(material));
    const variants = variantsOf(primitive);
    if (!variants || !materialsOf(primitive).some(isThick)) continue;
    // Meshes, such as levels, can share a list, but each has its own units.
    const list = variants.clone();
    for (const mapping of variants.listMappings()) {
      const own = mapping.getMaterial();
      list.removeMapping(mapping);
      list.addMapping(isThick(own) ? mapping.clone().setMaterial(scaled(own)) : mapping);
    }
    primitive.setExtension(VARIANTS, list);
  }
}

function scaledCopy(material: Material, scale: number): Material {
  const volume = volumeOf(material)!;
  const scaled = volume.clone().setThicknessFactor(scale * volume.getThicknessFactor());
  return material.clone().setExtension(VOLUME, scaled);
}
