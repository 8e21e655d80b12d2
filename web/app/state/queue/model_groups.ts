/** Groups files that were opened together into models with their companion files. */

import { isModelName } from '../../../engine/document/format_names';
import type { SourceFile } from '../../../engine/document/open';

/** A model and the files that may belong to it. */
export interface ModelGroup {
  /** of the model's file, with its folders */
  name: string;
  files: SourceFile[];
}

/** Formats that name no other files. */
const ALONE = /\.(stl|ply|off)$/i;

const folderOf = (name: string): string => name.slice(0, name.lastIndexOf('/') + 1);

/** One group for each model, in the order of their names; each has the other files in its folder and below. */
export function modelGroups(files: readonly SourceFile[]): ModelGroup[] {
  const models = files.filter(({ name }) => isModelName(name));
  const others = files.filter(({ name }) => !isModelName(name));
  const sorted = [...models].sort((a, b) => (a.name < b.name ? -1 : 1));
  return sorted.map((model) => {
    const folder = folderOf(model.name);
    const own = ALONE.test(model.name) ? [] : others.filter(({ name }) => name.startsWith(folder));
    return { name: model.name, files: [model, ...own] };
  });
}

/** The name of the result of a model: "bar-limber", and "bar-limber-2" if the model is such a result itself. */
export function suffixedName(name: string): string {
  const [, stem, number] = /^(.*)-limber(?:-(\d+))?$/.exec(name) ?? [];
  return stem === undefined ? `${name}-limber` : `${stem}-limber-${Number(number ?? 1) + 1}`;
}

/** `name` with another ending, made unique among `taken`: "a-limber.glb", "a-limber-2.glb". Adds it to `taken`. */
export function freeName(name: string, ending: string, taken: Set<string>): string {
  let free = suffixedName(name.replace(/\.[^./]+$/, ''));
  while (taken.has(free)) free = suffixedName(free);
  taken.add(free);
  return `${free}${ending}`;
}
