// Parses "--set key=value" into changes of the engine's settings.

/** Parses a value by the type of its default: a number, on or off, or text. */
function valueOf(text, usual) {
  if (typeof usual === 'boolean') {
    if (text !== 'on' && text !== 'off')
      throw new Error(`"${text}" is neither on nor off: write one of them.`);
    return text === 'on';
  }
  const number = Number(text);
  return Number.isNaN(number) ? text : number;
}

/** ["strainWeight=3", "fit=off"] -> { strainWeight: 3, fit: false }. Throws one sentence for an unknown key. */
export function readChanges(engine, pairs) {
  const defaults = engine.defaultSettings();
  const entries = pairs.map((pair) => {
    const [key, text] = pair.split('=');
    if (!(key in defaults) || text === undefined)
      throw new Error(
        `--set ${pair} names no setting: write key=value with a key of Settings in options.ts.`,
      );
    return [key, valueOf(text, defaults[key])];
  });
  return Object.fromEntries(entries);
}
