// Every include and import has to go along an arrow between rooms.

import { importEdges } from './imports.mjs';

/** The room of a path: the longest that the path lies in; undefined where it lies in none. */
export const roomOf = (path, rooms) =>
  Object.keys(rooms)
    .filter((room) => path === room || path.startsWith(`${room}/`))
    .sort((a, b) => b.length - a.length)[0];

/** Every include or import against an arrow, and every file outside the rooms, a sentence each. */
export function wrongArrows(files, rooms) {
  const code = files.filter(({ text }) => text);
  const homeless = code
    .filter(({ path }) => !roomOf(path, rooms))
    .map(({ path }) => `${path} lies in no room of scripts/structure/rooms.mjs.`);
  const wrong = importEdges(code).flatMap(({ from, to }) => {
    const [room, target] = [roomOf(from, rooms), roomOf(to, rooms)];
    const isAllowed = !room || !target || room === target || rooms[room].includes(target);
    return isAllowed ? [] : [`${from} imports ${to}, but ${room} must not know ${target}.`];
  });
  return [...homeless, ...wrong];
}
