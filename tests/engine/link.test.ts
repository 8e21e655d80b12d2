/** What the user wants goes through a link, Undo and a reload without a loss, numbers of faces of single bodies too. */

import { expect, it, vi } from 'vitest';
import { readLink, writeLink } from '../../web/app/state/link';
import { fittingOwnFaces } from '../../web/app/state/own_faces';
import { wants } from '../../web/app/state/store';
import { canUndo, readUndo, redo, restoreUndo, startUndo, undo } from '../../web/app/state/undo';
import { defaultSettings } from '../../web/engine/settings/options';

// The state of the page asks for the colour scheme.
vi.hoisted(() => vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} })));

const own = new Map([
  [5, 120],
  [2, 400],
]);

it('a link contains the faces of bodies with a number of their own', () => {
  const wanted = { settings: defaultSettings(), faces: 900, own, body: 2, file: 'a.glb' };
  const link = writeLink(wanted);
  expect(decodeURIComponent(link)).toBe('faces=900&own=2:400,5:120&body=2&file=a.glb');
  expect(readLink(link)).toEqual(wanted);
});

it.each(['own=', 'own=2', 'own=2:x', 'own=2:4,', 'own=-1:4', 'own=2:1e9'])(
  'a link with %s is refused',
  (word) => {
    expect(() => readLink(word)).toThrow(
      `The link has ${word}: give bodies with their faces, as in own=2:400.`,
    );
  },
);

it('numbers of a link apply if the file has such a body, up to its number of faces', () => {
  const bodies = [{ faces: 10 }, { faces: 10 }, { faces: 300 }];
  expect([...fittingOwnFaces(own, bodies)]).toEqual([[2, 300]]);
  expect(fittingOwnFaces(undefined, bodies).size).toBe(0);
});

it('Undo and Redo restore the faces of single bodies, also after a reload', () => {
  startUndo(() => {});
  wants.own.value = own;
  expect(canUndo()).toBe(true);
  restoreUndo(readUndo());
  undo();
  expect([...wants.own.value]).toEqual([]);
  redo();
  expect(new Map(wants.own.value)).toEqual(own);
});
