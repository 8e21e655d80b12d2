/** Patterns of names, as --mesh takes them. Names are untrusted, so backtracking is bounded. */

/**
 * Whether the pattern matches the whole `name`. `*` stands for any characters or none, `?` for one character, `|` separates patterns of
 * which one has to match; a backslash before one of these, or before itself, makes it literal. Case matters.
 * Takes time up to the product of the lengths.
 */
export const matchesPattern = (pattern: string, name: string): boolean =>
  alternatives(pattern).some((words) => matchesWords(words, Array.from(name)));

/** A literal character, or one of the two wildcards. */
type Word = { letter: string } | 'any' | 'one';

function alternatives(pattern: string): Word[][] {
  const all: Word[][] = [[]];
  for (const [part] of pattern.matchAll(/\\[*?|\\]|./gsu)) {
    if (part === '|') all.push([]);
    else if (part === '*') all[all.length - 1].push('any');
    else if (part === '?') all[all.length - 1].push('one');
    else
      all[all.length - 1].push({ letter: part.length > 1 && part.startsWith('\\') ? part.slice(1) : part });
  }
  return all;
}

/** Matches greedily; on a mismatch the last `*` takes one more character. */
function matchesWords(words: Word[], letters: string[]): boolean {
  let [word, letter, star, taken] = [0, 0, -1, 0];
  while (letter < letters.length) {
    if (word < words.length && agrees(words[word], letters[letter])) [word, letter] = [word + 1, letter + 1];
    else if (words[word] === 'any') [star, taken, word] = [word, letter, word + 1];
    else if (star >= 0) [word, taken, letter] = [star + 1, taken + 1, taken + 1];
    else return false;
  }
  return words.slice(word).every((rest) => rest === 'any');
}

const agrees = (word: Word, letter: string): boolean =>
  word === 'one' || (typeof word === 'object' && word.letter === letter);
