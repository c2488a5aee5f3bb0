package org.selectiverenderer.render.draw;

import com.jogamp.common.nio.Buffers;
import com.jogamp.common.nio.PointerBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.VersionFades;

/**
 * The visible set of a frame: the shapes that at least one eye sees, in drawing order, each with
 * the visible ranges of its index buffer. Consecutive items of one batch are one draw call, and
 * adjacent ranges are merged. Filled by {@link SceneRenderer#cull}; valid for all eyes that it was
 * culled for, until the next call.
 */
public final class VisibleSet {
  /**
   * The visible items of a version that is being faded.
   *
   * @param version tells in which pixels they are drawn
   */
  record Fading(VisibleSet items, VersionFades.FadingVersion version) {}

  /**
   * The first item of each draw call; the others of its batch differ only in their index ranges.
   */
  final List<DrawItem> calls = new ArrayList<>();

  /** The versions that are being faded; their items are in no call of this set. */
  final List<Fading> fading = new ArrayList<>();

  /** The number of opaque calls, which come first. */
  int opaque;

  /** The index of each call's first range, and the end of the last call's ranges. */
  int[] firstRange = new int[16];

  int ranges;

  /** Whether all eyes see only front faces, per call. */
  private boolean[] fronts = new boolean[15];

  private int shapes;
  private IntBuffer counts = Buffers.newDirectIntBuffer(1024);
  private PointerBuffer offsets = PointerBuffer.allocateDirect(1024);
  private @Nullable DrawItem begun;
  private long indices;
  private long indicesOfBegun;
  private int allOfBegun;
  private long rangeEnd;

  VisibleSet() {}

  void clear() {
    calls.clear();
    fading.clear();
    opaque = 0;
    ranges = 0;
    shapes = 0;
    begun = null;
    indices = 0;
    indicesOfBegun = 0;
  }

  /**
   * Begins an item, whose ranges are added next.
   *
   * @param all the indices of the refinement level that the ranges are part of
   */
  void begin(DrawItem item, int all) {
    shapes++;
    indices = own();
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

  /** Adds a range of the index buffer of the item begun last. */
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

  /** Notes that an eye may see back faces of the item begun last. */
  void backs() {
    fronts[calls.size() - 1] = false;
  }

  /** Returns whether every eye sees only front faces of what a call draws. */
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

  /** Returns the number of indices in some ranges. */
  long count(int fromRange, int toRange) {
    long sum = 0;
    for (int range = fromRange; range < toRange; range++) {
      sum += counts.get(range);
    }
    return sum;
  }

  /** Returns whether something of it is blended. */
  boolean blends() {
    return opaque < calls.size() || fading.stream().anyMatch(version -> version.items().blends());
  }

  /** Returns the number of visible shapes. */
  public int shapes() {
    return shapes + fading.stream().mapToInt(version -> version.items().shapes()).sum();
  }

  /** Returns the number of draw calls. */
  public int calls() {
    return calls.size();
  }

  /**
   * Returns the number of indices that are drawn for an eye, three per triangle; refined meshes
   * count with the triangles of the original mesh.
   */
  public long indices() {
    return own() + fading.stream().mapToLong(version -> version.items().own()).sum();
  }

  private long own() {
    return begun == null ? indices : indices + begun.own(indicesOfBegun, allOfBegun);
  }
}
