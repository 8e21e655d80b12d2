// Every include and import must follow an arrow between rooms.

import { importEdges } from './imports.mjs';

/** The room of a path: the longest room name that contains the path; undefined if none does. */
export const roomOf = (path, rooms) =>
  Object.keys(rooms)
    .filter((room) => path === room || path.startsWith(`${room}/`))
    .sort((a, b) => b.length - a.length)[0];

/** One sentence for every include or import that follows no arrow, and for every file outside of the rooms. */
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
