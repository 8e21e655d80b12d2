/**
 * Takes the place of the package ndarray-pixels in bundles, see the Vite configurations. As soon as it is imported it loads sharp, a
 * native program, in Node, and makes code of text, which the page forbids; and no function of glTF-Transform that is called here
 * reads or writes pixels.
 */

const refuse = (): never => {
  throw new Error('Pictures cannot be decoded here.');
};

export { refuse as getPixels, refuse as savePixels };
