/** Opens files by dialog, drop or address, and downloads files. */

import type { SourceFile } from '../../engine/document/open';
import type { Wanted } from '../state/link';
import { openFiles } from '../state/runner';
import { openAll } from './open_all';
import { status } from '../state/store';
import { say } from '../language/say';

const READABLE = '.glb,.gltf,.obj,.stl,.ply,.off,.zip';

async function readAll(files: Iterable<{ name: string; file: File }>): Promise<SourceFile[]> {
  const reads = Array.from(files, async ({ name, file }) => ({
    name,
    bytes: new Uint8Array(await file.arrayBuffer()),
  }));
  return Promise.all(reads);
}

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
      if (files.length > 0) await openAll(await readAll(files));
      resolve();
    };
    input.oncancel = () => resolve();
    input.click();
  });
}

/** Opens what was dropped: files, and all files below folders with their relative paths. */
export async function openDropped(items: DataTransferItemList): Promise<void> {
  const plain = Array.from(items, (item) => (item.webkitGetAsEntry?.() ? null : item.getAsFile()));
  const entries = Array.from(items, (item) => item.webkitGetAsEntry?.() ?? null).filter(
    (entry) => entry !== null,
  );
  const found = (await Promise.all(entries.map((entry) => filesBelow(entry, '')))).flat();
  const loose = plain.filter((file) => file !== null).map((file) => ({ name: file.name, file }));
  await openAll(await readAll([...found, ...loose]));
}

async function filesBelow(entry: FileSystemEntry, path: string): Promise<{ name: string; file: File }[]> {
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) =>
      (entry as FileSystemFileEntry).file(resolve, reject),
    );
    return [{ name: path + file.name, file }];
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
  const prefix = path === '' && children.some((child) => child.isFile) ? '' : `${path}${entry.name}/`;
  return (await Promise.all(children.map((child) => filesBelow(child, prefix)))).flat();
}

/** Opens a file of the page's own origin. */
export async function openAddress(address: string, name: string, wanted?: Wanted): Promise<void> {
  const response = await fetch(address);
  if (!response.ok) {
    status.notice.value = {
      kind: 'error',
      text: say('{name} could not be loaded: build the samples with npm run build.', { name }),
    };
    return;
  }
  await openFiles([{ name, bytes: new Uint8Array(await response.arrayBuffer()) }], wanted);
}

export function download(name: string, content: Uint8Array | string, type: string): void {
  const address = URL.createObjectURL(new Blob([content as BlobPart], { type }));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
