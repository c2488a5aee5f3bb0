package org.selectiverenderer.x3d.source;

/**
 * What a file may cost, so that a hostile one ends with a message instead of the memory's end.
 *
 * @param maxBytes length of the text after decompression; also bounds every attribute
 * @param maxRatio decompressed to compressed length, asked from the second MiB of output on
 * @param maxDepth elements within elements, instances of prototypes counted as what they stand for
 * @param maxNodes nodes, instances of prototypes and those that they make
 */
public record ReadLimits(long maxBytes, int maxRatio, int maxDepth, int maxNodes) {
  /**
   * 1 GiB but no more than a quarter of the heap, since the text is held while it is read; 1000:1,
   * where real scenes have 3:1 to 30:1; 250 levels, which fit a stack of half a MiB; 4 million
   * nodes, fewer on a small heap.
   */
  public static ReadLimits standard() {
    long heap = Runtime.getRuntime().maxMemory();
    return new ReadLimits(
        Math.min(1L << 30, heap / 4), 1000, 250, (int) Math.min(4_000_000, heap / 512));
  }
}
