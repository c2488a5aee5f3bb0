package org.selectiverenderer.geometry.mesh;

import org.jspecify.annotations.Nullable;

/** Welds vertices whose attributes are all equal; minus zero counts as zero. */
public final class VertexWelder {
  private final int count;
  private final float[][] arrays;
  private final int[] components;
  private final int[] renamed;
  private int unique;

  /** Creates a welder; arrays hold {@code count} tuples: x, y, z; x, y, z; r, g, b, a; s, t. */
  public VertexWelder(
      int count,
      float[] positions,
      float @Nullable [] normals,
      float @Nullable [] colors,
      float @Nullable [] texCoords) {
    this.count = count;
    float[][] all = {positions, normals, colors, texCoords};
    int[] sizes = {3, 3, 4, 2};
    int used = 0;
    for (float[] array : all) {
      used += array == null ? 0 : 1;
    }
    this.arrays = new float[used][];
    this.components = new int[used];
    for (int i = 0, j = 0; i < all.length; i++) {
      if (all[i] != null) {
        arrays[j] = all[i];
        components[j++] = sizes[i];
      }
    }
    this.renamed = new int[count];
  }

  /** Renumbers vertices in order of first appearance; returns the number of distinct ones. */
  public int weld() {
    int[] hashes = hashes();
    int[] table = new int[Integer.highestOneBit(Math.max(8, count)) * 4];
    int mask = table.length - 1;
    for (int vertex = 0; vertex < count; vertex++) {
      int hash = hashes[vertex];
      int slot = hash & mask;
      while (table[slot] != 0
          && !(hashes[table[slot] - 1] == hash && same(table[slot] - 1, vertex))) {
        slot = (slot + 1) & mask;
      }
      if (table[slot] == 0) {
        table[slot] = vertex + 1;
        renamed[vertex] = unique++;
      } else {
        renamed[vertex] = renamed[table[slot] - 1];
      }
    }
    return unique;
  }

  private int[] hashes() {
    int[] hashes = new int[count];
    for (int k = 0; k < arrays.length; k++) {
      float[] values = arrays[k];
      int size = components[k];
      for (int vertex = 0, i = 0; vertex < count; vertex++) {
        int hash = hashes[vertex];
        for (int end = i + size; i < end; i++) {
          hash = (hash ^ Float.floatToRawIntBits(values[i] + 0.0f)) * 0x9E3779B1;
          hash ^= hash >>> 15;
        }
        hashes[vertex] = hash;
      }
    }
    return hashes;
  }

  private boolean same(int a, int b) {
    for (int k = 0; k < arrays.length; k++) {
      float[] values = arrays[k];
      int size = components[k];
      for (int i = a * size, j = b * size, end = i + size; i < end; i++, j++) {
        if (values[i] != values[j]) {
          return false;
        }
      }
    }
    return true;
  }

  /** Returns the new index of each vertex; not a copy. */
  public int[] numbers() {
    return renamed;
  }

  /** Replaces vertex indices by the new ones. */
  public void rename(int[] indices) {
    for (int i = 0; i < indices.length; i++) {
      indices[i] = renamed[indices[i]];
    }
  }

  /** Replaces vertex indices by those of the first equal vertices, so that no tuple moves. */
  public void unite(int[] indices) {
    int[] first = new int[unique];
    for (int vertex = count - 1; vertex >= 0; vertex--) {
      first[renamed[vertex]] = vertex;
    }
    for (int i = 0; i < indices.length; i++) {
      indices[i] = first[renamed[indices[i]]];
    }
  }

  /** Returns the tuples of the distinct vertices. */
  public float[] compact(float[] values, int size) {
    float[] kept = new float[unique * size];
    int next = 0;
    for (int vertex = 0; vertex < count; vertex++) {
      if (renamed[vertex] == next) {
        System.arraycopy(values, vertex * size, kept, next * size, size);
        next++;
      }
    }
    return kept;
  }
}
