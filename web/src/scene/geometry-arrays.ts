/** X_ITE fills such an array number by number, and then hands it to the graphics card. */
export interface GeometryArray extends Array<number> {
  getValue: (this: GeometryArray) => Float32Array;
  shrinkToFit: (this: GeometryArray) => Float32Array;
}

/**
 * Makes X_ITE's arrays of vertices turn into arrays for the graphics card by a plain loop: X_ITE hands them to a
 * constructor that asks each for its iterator, which takes ten times as long.
 *
 * @param example any such array
 */
export function copyArraysFast(example: GeometryArray): void {
  const copies = new WeakMap<GeometryArray, Float32Array>();
  const kind = Object.getPrototypeOf(example) as GeometryArray;
  const none = new Float32Array();
  kind.getValue = function (this: GeometryArray) {
    return copies.get(this) ?? none;
  };
  kind.shrinkToFit = function (this: GeometryArray) {
    const { length } = this;
    const known = copies.get(this);
    const copy = known?.length === length ? known : new Float32Array(length);
    for (let i = 0; i < length; i++) {
      copy[i] = this[i] ?? 0;
    }
    copies.set(this, copy);
    return copy;
  };
}
