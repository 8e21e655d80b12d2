/** Opens files by dialog, drop or address, and downloads files. */

import type { SourceFile } from '../../engine/document/open';
import { openFiles } from '../state/runner';
import type { HowToOpen } from '../state/runner';
import { openAll } from './open_all';
import { complain } from '../state/running';
import { say } from '../language/say';

const READABLE = '.glb,.gltf,.obj,.stl,.ply,.off,.zip';

/** A file of the user's computer, with its folders in its name. */
interface NamedFile {
  name: string;
  file: File;
}

/** Opens these files; a notice names those that cannot be read. */
async function openRead(files: Promise<NamedFile[]>): Promise<void> {
  let read: SourceFile[];
  try {
    read = await Promise.all((await files).map(bytesOf));
  } catch (error) {
    return complain(error);
  }
  await openAll(read);
}

async function bytesOf({ name, file }: NamedFile): Promise<SourceFile> {
  const bytes = await file.arrayBuffer().catch(() => Promise.reject(unreadable(name)));
  return { name, bytes: new Uint8Array(bytes) };
}

const unreadable = (name: string): Error =>
  new Error(
    say('{name} cannot be read: it was moved or changed in the meantime, or is too large for this browser.', {
      name,
    }),
  );

/** Lets the user choose files and opens them. */
export function pickFiles(): Promise<void> {
  return new Promise((resolve) => {
    const input = document.createElement('input');
    input.type = 'file';
    input.multiple = true;
    // Companion files of a .gltf may have any name; these are the usual kinds.
    input.accept = `${READABLE},.bin,.png,.jpg,.jpeg,.webp,.ktx2,.mtl,.json`;
    input.onchange = async () => {
      const files = Array.from(input.files ?? [], (file) => ({ name: file.name, file }));
      if (files.length > 0) await openRead(Promise.resolve(files));
      resolve();
    };
    input.oncancel = () => resolve();
    input.click();
  });
}

/** Opens a drop: files, and all files below folders with their relative paths. */
export async function openDropped(items: DataTransferItemList): Promise<void> {
  const plain = Array.from(items, (item) => (item.webkitGetAsEntry?.() ? null : item.getAsFile()));
  const entries = Array.from(items, (item) => item.webkitGetAsEntry?.() ?? null).filter(
    (entry) => entry !== null,
  );
  const loose = plain.filter((file) => file !== null).map((file) => ({ name: file.name, file }));
  await openRead(filesOf(entries).then((found) => [...found, ...loose]));
}

/** All files of these entries and below them, with their relative paths. */
async function filesOf(entries: readonly FileSystemEntry[]): Promise<NamedFile[]> {
  const found = await Promise.all(
    entries.map((entry) => filesBelow(entry, '').catch(() => Promise.reject(unreadable(entry.name)))),
  );
  // Several folders need their names, because their files may have the same names.
  const isAlone = entries.filter(({ isDirectory }) => isDirectory).length === 1;
  return found.flatMap((files, i) => (isAlone && entries[i].isDirectory ? insideOf(files) : files));
}

/** The files of a folder without its name, if it directly contains any files. */
function insideOf(files: NamedFile[]): NamedFile[] {
  const inside = files.map(({ name, file }) => ({ name: name.slice(name.indexOf('/') + 1), file }));
  return inside.some(({ name }) => !name.includes('/')) ? inside : files;
}

async function filesBelow(entry: FileSystemEntry, folder: string): Promise<NamedFile[]> {
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) =>
      (entry as FileSystemFileEntry).file(resolve, reject),
    );
    return [{ name: folder + file.name, file }];
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const children: FileSystemEntry[] = [];
  for (;;) {
    const batch = await new Promise<FileSystemEntry[]>((resolve, reject) =>
      reader.readEntries(resolve, reject),
    );
    if (batch.length === 0) break;
    children.push(...batch);
  }
  const below = children.map((child) => filesBelow(child, `${folder}${entry.name}/`));
  return (await Promise.all(below)).flat();
}

/** Opens a file of the page's own origin; a notice says why it cannot be loaded. */
export async function openAddress(address: string, name: string, how?: HowToOpen): Promise<void> {
  try {
    const response = await fetch(address);
    if (!response.ok)
      throw new Error(say('{name} could not be loaded: build the samples with npm run build.', { name }));
    await openFiles([{ name, bytes: new Uint8Array(await response.arrayBuffer()) }], how);
  } catch (error) {
    complain(error);
  }
}

export function download(name: string, content: Uint8Array | string, type: string): void {
  const address = URL.createObjectURL(new Blob([content as BlobPart], { type }));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
