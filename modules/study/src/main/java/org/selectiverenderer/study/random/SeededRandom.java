package org.selectiverenderer.study.random;

import java.util.Random;

/** Makes random number generators from a seed and a text. */
public final class SeededRandom {
  private SeededRandom() {}

  /** Returns a generator whose numbers depend on a seed and a text alone. */
  public static Random of(long seed, String text) {
    return new Random(mixed(seed, text) * 0x9E3779B97F4A7C15L);
  }

  /** Returns a seed that depends on another one and a text. */
  public static long mixed(long seed, String text) {
    long mixed = seed;
    for (char c : text.toCharArray()) {
      mixed = (mixed ^ c) * 0x100000001B3L; // FNV-1a, whose low bits Random then spreads.
    }
    return mixed;
  }
}
