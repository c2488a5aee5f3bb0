package org.selectiverenderer.geometry.mesh;

import java.lang.ref.WeakReference;
import org.jspecify.annotations.Nullable;

/**
 * The indices of a mesh: as an array of integers or, with half the memory, as two bytes each, from
 * which the array is made anew when somebody reads it and nobody has it any more. Immutable.
 */
final class CompactIndices {
  /** The number of vertices that two bytes can address. */
  private static final int ADDRESSABLE = 1 << 16;

  /** Fewer indices are not worth the work. */
  private static final int LEAST = 1024;

  private final int @Nullable [] wide;
  private final short[] narrow;

  /** The array made of two-byte indices, while somebody has it. */
  private volatile @Nullable WeakReference<int[]> made;

  private CompactIndices(int @Nullable [] wide, short[] narrow) {
    this.wide = wide;
    this.narrow = narrow;
  }

  /** Returns indices that are kept as they are. */
  static CompactIndices of(int[] indices) {
    return new CompactIndices(indices, new short[0]);
  }

  int count() {
    return wide == null ? narrow.length : wide.length;
  }

  boolean keeps(Object array) {
    return array == wide;
  }

  /** Returns the indices as two bytes each; these if they are that already or must stay wide. */
  CompactIndices compact(int vertices) {
    if (wide == null || wide.length < LEAST || vertices > ADDRESSABLE) {
      return this;
    }
    short[] half = new short[wide.length];
    for (int i = 0; i < half.length; i++) {
      half[i] = (short) wide[i];
    }
    return new CompactIndices(null, half);
  }

  int[] array() {
    if (wide != null) {
      return wide;
    }
    WeakReference<int[]> known = made;
    int[] array = known == null ? null : known.get();
    if (array == null) {
      array = new int[narrow.length];
      for (int i = 0; i < array.length; i++) {
        array[i] = narrow[i] & 0xffff;
      }
      made = new WeakReference<>(array);
    }
    return array;
  }
}
