package org.selectiverenderer.x3d.source;

/**
 * The resource limits of reading a file, so that a hostile file causes a message instead of
 * exhausting the memory.
 *
 * @param maxBytes the length of the text after decompression, which also bounds every attribute
 * @param maxRatio the compression ratio, checked from the second MiB of output on
 * @param maxDepth the nesting depth of elements, including those of expanded prototypes
 * @param maxNodes the number of nodes of a file, including prototype instances and their nodes
 * @param maxSceneNodes the number of nodes of a scene with all its Inlines, in which a file may be
 *     used very often
 */
public record ReadLimits(
    long maxBytes, int maxRatio, int maxDepth, int maxNodes, int maxSceneNodes) {
  /** Makes limits where a scene with its Inlines may have as many nodes as a file. */
  public ReadLimits(long maxBytes, int maxRatio, int maxDepth, int maxNodes) {
    this(maxBytes, maxRatio, maxDepth, maxNodes, maxNodes);
  }

  /**
   * Returns the standard limits: 1 GiB but at most a quarter of the heap, since the text is kept
   * while it is read; a ratio of 1000:1, while real scenes have 3:1 to 30:1; 250 levels, which fit
   * a stack of half a MiB; 4 million nodes in a file and 16 million with its Inlines, fewer on a
   * small heap.
   */
  public static ReadLimits standard() {
    long heap = Runtime.getRuntime().maxMemory();
    return new ReadLimits(
        Math.min(1L << 30, heap / 4),
        1000,
        250,
        (int) Math.min(4_000_000, heap / 512),
        (int) Math.min(16_000_000, heap / 512));
  }
}
