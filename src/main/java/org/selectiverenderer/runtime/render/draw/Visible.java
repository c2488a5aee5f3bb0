package org.selectiverenderer.runtime.render.draw;

import com.jogamp.common.nio.Buffers;
import com.jogamp.common.nio.PointerBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What a frame draws: the shapes that some eye sees, in the order of drawing, and of each the
 * stretches of its index buffer. Neighbours of one batch are one call, stretches that touch are one
 * stretch. Filled by {@link SceneRenderer#cull}, good for every eye that it was made for, until the
 * next call.
 */
public final class Visible {
  /** The first item of each call; the others of a batch differ from it in nothing but stretches. */
  final List<DrawItem> calls = new ArrayList<>();

  /** How many of the calls are opaque; they come first. */
  int opaque;

  /** Where each call's stretches begin, and where those of the last end. */
  int[] firstRange = new int[16];

  int ranges;

  /** Of each call whether all eyes see nothing of it but fronts. */
  private boolean[] fronts = new boolean[15];

  private int shapes;
  private IntBuffer counts = Buffers.newDirectIntBuffer(1024);
  private PointerBuffer offsets = PointerBuffer.allocateDirect(1024);
  private @Nullable DrawItem begun;
  private long indices;
  private long indicesOfBegun;
  private int allOfBegun;
  private long rangeEnd;

  Visible() {}

  void clear() {
    calls.clear();
    opaque = 0;
    ranges = 0;
    shapes = 0;
    begun = null;
    indices = 0;
    indicesOfBegun = 0;
  }

  /**
   * Begins an item: its stretches follow.
   *
   * @param all indices of the stage of its mesh that they are of
   */
  void begin(DrawItem item, int all) {
    shapes++;
    indices = indices();
    indicesOfBegun = 0;
    begun = item;
    allOfBegun = all;
    DrawBatch batch = item.part().batch();
    if (batch != null && !calls.isEmpty() && calls.get(calls.size() - 1).part().batch() == batch) {
      return;
    }
    if (firstRange.length < calls.size() + 2) {
      firstRange = Arrays.copyOf(firstRange, 2 * firstRange.length);
      fronts = Arrays.copyOf(fronts, firstRange.length - 1);
    }
    fronts[calls.size()] = true;
    calls.add(item);
    opaque += item.blended() ? 0 : 1;
    firstRange[calls.size() - 1] = ranges;
    firstRange[calls.size()] = ranges;
  }

  /** Adds a stretch of the index buffer of the item begun last. */
  void range(int firstIndex, int count, int indexBytes) {
    long byteOffset = (long) firstIndex * indexBytes;
    indicesOfBegun += count;
    if (ranges > firstRange[calls.size() - 1] && byteOffset == rangeEnd) {
      counts.put(ranges - 1, counts.get(ranges - 1) + count);
    } else {
      if (ranges == counts.capacity()) {
        grow();
      }
      counts.put(ranges, count);
      offsets.put(ranges++, byteOffset);
      firstRange[calls.size()] = ranges;
    }
    rangeEnd = byteOffset + (long) count * indexBytes;
  }

  /** Of the item begun last some eye may see backs. */
  void backs() {
    fronts[calls.size() - 1] = false;
  }

  /** Whether every eye sees nothing but fronts of what a call draws. */
  boolean frontOnly(int call) {
    return fronts[call];
  }

  private void grow() {
    IntBuffer moreCounts = Buffers.newDirectIntBuffer(2 * ranges);
    moreCounts.put(counts.clear()).clear();
    counts = moreCounts;
    PointerBuffer moreOffsets = PointerBuffer.allocateDirect(2 * ranges);
    for (int i = 0; i < ranges; i++) {
      moreOffsets.put(i, offsets.get(i));
    }
    offsets = moreOffsets;
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

  /** The indices of some stretches together. */
  long count(int fromRange, int toRange) {
    long sum = 0;
    for (int range = fromRange; range < toRange; range++) {
      sum += counts.get(range);
    }
    return sum;
  }

  /** The number of shapes in it. */
  public int shapes() {
    return shapes;
  }

  /** The number of calls that draw them. */
  public int calls() {
    return calls.size();
  }

  /**
   * The number of indices that an eye's drawing takes, three per triangle; of meshes that are drawn
   * finer than they are, those of the mesh itself.
   */
  public long indices() {
    return begun == null ? indices : indices + begun.own(indicesOfBegun, allOfBegun);
  }
}
