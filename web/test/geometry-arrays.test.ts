import { describe, expect, it } from 'vitest';
import { copyArraysFast } from '../src/scene/geometry-arrays.js';

class Vertices extends Array<number> {
  getValue(): Float32Array {
    return expect.unreachable();
  }
  shrinkToFit(): Float32Array {
    return expect.unreachable();
  }
}

describe("X_ITE's arrays of vertices", () => {
  it('are copied for the graphics card, into the same memory where the length is the same', () => {
    const vertices = new Vertices();
    copyArraysFast(new Vertices());
    expect([...vertices.getValue()]).toEqual([]);
    vertices.push(1, 2.5, -3);
    const first = vertices.shrinkToFit();
    expect([...first]).toEqual([1, 2.5, -3]);
    expect(vertices.getValue()).toBe(first);
    vertices[1] = 4;
    expect(vertices.shrinkToFit()).toBe(first);
    expect([...first]).toEqual([1, 4, -3]);
    vertices.push(5);
    expect([...vertices.shrinkToFit()]).toEqual([1, 4, -3, 5]);
    vertices.length = 0;
    expect([...vertices.shrinkToFit()]).toEqual([]);
  });

  it('keep their contents apart', () => {
    const [one, other] = [new Vertices(), new Vertices()];
    copyArraysFast(one);
    one.push(1);
    one.shrinkToFit();
    expect([...other.getValue()]).toEqual([]);
  });
});
