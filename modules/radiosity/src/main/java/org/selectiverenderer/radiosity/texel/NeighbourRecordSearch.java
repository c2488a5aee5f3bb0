package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import org.selectiverenderer.geometry.bvh.Bvh;
import org.selectiverenderer.geometry.bvh.BvhBuilder;

/**
 * Finds the records around one record, sorted into rings by distance. The search runs once for each
 * record, so the positions are kept in an array of their own. One per thread.
 */
final class NeighbourRecordSearch {
  private final Places places;
  private final double[] squares;
  private final int[] ends;
  private final double[] box = new double[6];
  private double x;
  private double y;
  private double z;
  private int group;
  private int[] found = new int[64];
  private int[] rings = new int[64];
  private int[] sorted = new int[64];
  private int count;

  /** The positions and groups of records, shared by all threads. */
  static final class Places {
    private final float[] points;
    private final int[] groups;
    private final Bvh tree;

    /** Copies the positions of the present records; records added later are not found. */
    Places(IrradianceCache records) {
      float[] all = records.numbers();
      points = new float[3 * records.size()];
      for (int i = 0; i < records.size(); i++) {
        System.arraycopy(all, IrradianceCache.NUMBERS * i, points, 3 * i, 3);
      }
      groups = records.groups();
      tree =
          BvhBuilder.build(
              records.size(),
              (item, box) -> {
                for (int axis = 0; axis < 3; axis++) {
                  box[axis] = points[3 * item + axis];
                  box[axis + 3] = box[axis];
                }
              });
    }
  }

  /**
   * @param rings number of rings
   */
  NeighbourRecordSearch(Places places, int rings) {
    this.places = places;
    squares = new double[rings];
    ends = new int[rings];
  }

  /**
   * Finds the records of a record's group around it, itself included.
   *
   * @param widths the outer radius of each ring, metres, ascending
   */
  void find(int record, double[] widths) {
    float[] points = places.points;
    x = points[3 * record];
    y = points[3 * record + 1];
    z = points[3 * record + 2];
    group = places.groups[record];
    double most = widths[squares.length - 1];
    for (int axis = 0; axis < 3; axis++) {
      box[axis] = points[3 * record + axis] - most;
      box[axis + 3] = points[3 * record + axis] + most;
    }
    for (int ring = 0; ring < squares.length; ring++) {
      squares[ring] = widths[ring] * widths[ring];
    }
    Arrays.fill(ends, 0);
    count = 0;
    places.tree.overlap(box, this::keep);
    sort();
  }

  private void keep(int other) {
    if (places.groups[other] != group) {
      return;
    }
    double dx = places.points[3 * other] - x;
    double dy = places.points[3 * other + 1] - y;
    double dz = places.points[3 * other + 2] - z;
    double square = dx * dx + dy * dy + dz * dz;
    int ring = 0;
    while (ring < squares.length && square >= squares[ring]) {
      ring++;
    }
    if (ring == squares.length) {
      return;
    }
    if (count == found.length) {
      found = Arrays.copyOf(found, 2 * count);
      rings = Arrays.copyOf(rings, 2 * count);
      sorted = new int[2 * count];
    }
    found[count] = other;
    rings[count++] = ring;
    ends[ring]++;
  }

  /** Sorts the records by ring, inner rings first, in a stable order (counting sort). */
  private void sort() {
    int start = 0;
    for (int ring = 0; ring < ends.length; ring++) {
      int inRing = ends[ring];
      ends[ring] = start;
      start += inRing;
    }
    for (int i = 0; i < count; i++) {
      sorted[ends[rings[i]]++] = found[i];
    }
  }

  /** Returns the index at which a ring's records end and those of the next ring begin. */
  int end(int ring) {
    return ends[ring];
  }

  /** Returns one of the records found, inner rings first. */
  int record(int i) {
    return sorted[i];
  }
}
