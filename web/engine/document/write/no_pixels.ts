/**
 * Replaces the package ndarray-pixels in bundles, see the Vite configurations. That package loads sharp, a
 * native library, on import in Node, and evaluates text as code, which the page forbids; and no function of glTF-Transform that is called here
 * reads or writes pixels.
 */

const refuse = (): never => {
  throw new Error('Pictures cannot be decoded here.');
};

export { refuse as getPixels, refuse as savePixels };
