package org.selectiverenderer.statistics.simulation;

/**
 * Derives the seeds of independent random streams: one for each study, and one for each participant
 * in it. They are mixed by the finaliser of SplitMix64 (Steele, Lea and Flood 2014, OOPSLA):
 * SplittableRandom steps by that generator's own constant, so that seeds a constant apart could
 * give the same numbers, shifted.
 */
final class SeedSequence {
  private SeedSequence() {}

  static long of(long seed, int index) {
    return mixed(mixed(seed) + index);
  }

  private static long mixed(long value) {
    long z = (value ^ value >>> 30) * 0xbf58476d1ce4e5b9L;
    z = (z ^ z >>> 27) * 0x94d049bb133111ebL;
    return z ^ z >>> 31;
  }
}
