// What a page is watched with while it is measured: calls of WebGL and the page's own frames.

/** Runs in the page before its own scripts; what it sees is in `globalThis.measured`, times in ms. */
export function observe() {
  const measured = { gl: [], frames: [], uploads: [], usable: null };
  globalThis.measured = measured;
  watchWebgl();
  watchFrames();
  watchStart();

  function watchWebgl() {
    const uploads = new Set(['bufferData', 'bufferSubData', 'texImage2D', 'texSubImage2D', 'texStorage2D']);
    for (const name of Object.getOwnPropertyNames(WebGL2RenderingContext.prototype)) {
      const { value } = Object.getOwnPropertyDescriptor(WebGL2RenderingContext.prototype, name);
      if (typeof value !== 'function' || name === 'constructor') continue;
      WebGL2RenderingContext.prototype[name] = function (...args) {
        const start = performance.now();
        const result = value.apply(this, args);
        const duration = performance.now() - start;
        if (duration > 0.05) measured.gl.push({ start, duration, name });
        if (uploads.has(name)) measured.uploads.push({ start, duration, bytes: args[1]?.byteLength ?? 0 });
        return result;
      };
    }
    for (const name of ['width', 'height']) watchSize(name);
    const { getExtension } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.getExtension = function (name) {
      const extension = getExtension.call(this, name);
      if (name === 'WEBGL_lose_context' && extension) watchLoss(extension);
      return extension;
    };
  }

  /** Where a canvas is drawn on with WebGL, a new size waits for all that is still to be drawn. */
  function watchSize(name) {
    const { get, set } = Object.getOwnPropertyDescriptor(HTMLCanvasElement.prototype, name);
    Object.defineProperty(HTMLCanvasElement.prototype, name, {
      configurable: true,
      get,
      set(value) {
        const start = performance.now();
        set.call(this, value);
        const duration = performance.now() - start;
        if (duration > 0.2) measured.gl.push({ start, duration, name });
      },
    });
  }

  function watchLoss(extension) {
    const lose = extension.loseContext.bind(extension);
    extension.loseContext = () => {
      const start = performance.now();
      lose();
      measured.gl.push({ start, duration: performance.now() - start, name: 'loseContext' });
    };
  }

  function watchFrames() {
    const request = globalThis.requestAnimationFrame.bind(globalThis);
    globalThis.requestAnimationFrame = (callback) =>
      request((time) => {
        const start = performance.now();
        callback(time);
        measured.frames.push({ start, end: performance.now() });
      });
  }

  function watchStart() {
    new MutationObserver((_, observer) => {
      const open = [...document.querySelectorAll('button')].some(
        (button) => button.textContent.trim().startsWith('Open') && !button.disabled,
      );
      if (!open) return;
      measured.usable = performance.now();
      observer.disconnect();
    }).observe(document, { childList: true, subtree: true });
  }
}

/** Runs in the page: from now on nothing is drawn with WebGL. */
export function drawNothing() {
  for (const name of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced'])
    WebGL2RenderingContext.prototype[name] = () => undefined;
}

/** Forgets what has been measured so far. */
export const forget = (page) =>
  page.evaluate(() => {
    for (const list of ['gl', 'frames', 'uploads']) globalThis.measured[list].length = 0;
  });

/**
 * Moves the slider to 12 places, each once the rasteriser has nothing left to draw. Returns per place, in ms without calls of WebGL: until the label has changed, until the picture
 * has been handed over (without the wait for a frame and without uploads), the uploads, and all calls of WebGL.
 */
export const scrub = (page) =>
  page.evaluate(async () => {
    const { measured } = globalThis;
    const input = document.querySelector('#faces');
    const label = () => document.querySelector('.readouts dd')?.textContent;
    const [low, high] = [Number(input.min), Number(input.max)];
    const sum = (list) => list.reduce((all, { duration }) => all + duration, 0);
    const set = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, 'value').set;
    const nextFrame = () => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    const changed = (before) =>
      new Promise((resolve) => {
        const finish = (at) => {
          observer.disconnect();
          clearTimeout(timer);
          resolve(at);
        };
        const observer = new MutationObserver(() => label() !== before && finish(performance.now()));
        const timer = setTimeout(() => finish(Infinity), 8000);
        observer.observe(document.querySelector('.readouts'), {
          subtree: true,
          childList: true,
          characterData: true,
        });
      });
    const webgl = document.querySelector('.viewport canvas').getContext('webgl2');
    const finish = Object.getPrototypeOf(webgl).finish.bind(webgl);
    const rest = async () => {
      for (let frame = 0; frame < 3; frame++) await nextFrame();
      finish();
    };
    const ticks = [];
    for (let i = 1; i <= 12; i++) {
      await rest();
      const start = performance.now();
      const seen = changed(label());
      set.call(input, String(Math.round(high - ((high - low) * i) / 15)));
      input.dispatchEvent(new Event('input', { bubbles: true }));
      const at = await seen;
      const glBefore = sum(measured.gl.filter((call) => call.start >= start && call.start < at));
      let drawn = null;
      for (let wait = 0; wait < 200 && !drawn; wait++) {
        await nextFrame();
        const upload = measured.uploads.find((one) => one.start >= start && one.bytes > 1000);
        drawn = upload && measured.frames.find((one) => one.start <= upload.start && one.end > upload.start);
      }
      const inFrame = drawn
        ? measured.gl.filter((call) => call.start >= drawn.start && call.start < drawn.end)
        : [];
      const uploads = measured.uploads.filter(
        (one) => drawn && one.start >= drawn.start && one.start < drawn.end,
      );
      const ownFrame = drawn ? drawn.end - drawn.start - sum(inFrame) : Infinity;
      const labelTime = at - start - glBefore;
      ticks.push({
        label: labelTime,
        picture: labelTime + ownFrame,
        uploads: sum(uploads),
        calls: glBefore + sum(inFrame),
      });
    }
    return ticks;
  });
