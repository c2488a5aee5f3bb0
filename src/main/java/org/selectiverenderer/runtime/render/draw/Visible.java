package org.selectiverenderer.runtime.render.draw;

import com.jogamp.common.nio.Buffers;
import com.jogamp.common.nio.PointerBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;

/**
 * What a frame draws: the shapes that some eye sees, in the order of drawing, and of each the
 * stretches of its index buffer. Filled by {@link SceneRenderer#cull}, good for every eye that it
 * was made for, until the next call.
 */
public final class Visible {
  final List<DrawItem> items = new ArrayList<>();
  int opaque;
  int[] firstRange = new int[16];
  int ranges;
  private IntBuffer counts = Buffers.newDirectIntBuffer(1024);
  private PointerBuffer offsets = PointerBuffer.allocateDirect(1024);
  private long indices;
  private long pending;

  Visible() {}

  void clear() {
    items.clear();
    opaque = 0;
    ranges = 0;
    indices = 0;
    pending = 0;
  }

  /** Ends the stretches of the item last added. */
  void add(DrawItem item) {
    if (firstRange.length < items.size() + 2) {
      firstRange = java.util.Arrays.copyOf(firstRange, 2 * firstRange.length);
    }
    items.add(item);
    indices += item.own(pending);
    pending = 0;
    firstRange[items.size()] = ranges;
  }

  /** Adds a stretch of the index buffer of the item that is added next. */
  void range(long byteOffset, int count) {
    if (ranges == counts.capacity()) {
      IntBuffer moreCounts = Buffers.newDirectIntBuffer(2 * ranges);
      moreCounts.put(counts.clear()).clear();
      counts = moreCounts;
      PointerBuffer moreOffsets = PointerBuffer.allocateDirect(2 * ranges);
      for (int i = 0; i < ranges; i++) {
        moreOffsets.put(i, offsets.get(i));
      }
      offsets = moreOffsets;
    }
    counts.put(ranges, count);
    offsets.put(ranges++, byteOffset);
    pending += count;
  }

  IntBuffer counts(int from) {
    return counts.position(from);
  }

  PointerBuffer offsets(int from) {
    offsets.position(from);
    return offsets;
  }

  long offset(int range) {
    return offsets.get(range);
  }

  int count(int range) {
    return counts.get(range);
  }

  /** The number of shapes in it. */
  public int shapes() {
    return items.size();
  }

  /**
   * The number of indices that an eye's drawing takes, three per triangle; of meshes that are drawn
   * finer than they are, those of the mesh itself.
   */
  public long indices() {
    return indices;
  }
}
