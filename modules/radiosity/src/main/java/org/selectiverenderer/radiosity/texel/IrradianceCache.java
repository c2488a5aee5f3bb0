package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import org.selectiverenderer.geometry.bvh.Bvh;
import org.selectiverenderer.geometry.bvh.BvhBuilder;

/**
 * The irradiance cache: records of indirect irradiance at irregular surface points (Ward et al.
 * 1988), each with a radius of validity. One thread adds records, then several threads read them.
 */
final class IrradianceCache {
  // Offsets in the numbers of a record: position (at 0), normal, radius, error, irradiance,
  // rotational gradient, number of rays, whether the point is shaded flat, walls nearby.
  static final int NORMAL = 3;
  static final int RADIUS = 6;
  static final int ERROR = 7;
  static final int LIGHT = 8;
  static final int TURN = 11;
  static final int RAYS = 20;
  static final int FLAT = 21;
  static final int WALLS = 22;
  static final int NUMBERS = WALLS + NearbyWallPlanes.NUMBERS;

  private float[] numbers = new float[0];
  private int[] groups = new int[0];
  private int[] texels = new int[0];
  private int size;
  private boolean evened;
  private Bvh tree = BvhBuilder.build(0, (item, box) -> {});

  int size() {
    return size;
  }

  /** Returns {@link #NUMBERS} numbers per record; the first {@link #size} records are valid. */
  float[] numbers() {
    return numbers;
  }

  /** Returns the group of each record; points of one group see the same scene. */
  int[] groups() {
    return groups;
  }

  /** Returns the texel at which each record was gathered. */
  int[] texels() {
    return texels;
  }

  /**
   * Returns whether the records were denoised, so that the remaining errors of neighbouring records
   * are correlated.
   */
  boolean evened() {
    return evened;
  }

  /**
   * Returns the tree over the bounding boxes of the records' spheres of validity, as of the last
   * call of {@link #index}.
   */
  Bvh tree() {
    return tree;
  }

  /** Writes a record into a block of records. */
  static void write(
      TexelSurfacePoint place, double radius, IrradianceRecord record, float[] block, int at) {
    for (int i = 0; i < 3; i++) {
      block[at + i] = (float) place.point[i];
      block[at + NORMAL + i] = (float) place.normal[i];
      block[at + LIGHT + i] = (float) record.light[i];
    }
    block[at + RADIUS] = (float) radius;
    block[at + ERROR] = (float) record.error;
    for (int i = 0; i < 9; i++) {
      block[at + TURN + i] = (float) record.turn[i];
    }
    block[at + RAYS] = record.rays;
    block[at + FLAT] = place.flat() ? 1 : 0;
    System.arraycopy(record.walls, 0, block, at + WALLS, NearbyWallPlanes.NUMBERS);
  }

  /**
   * Averages a record with the result of further rays from the same point, weighted by the numbers
   * of rays.
   */
  void join(int number, IrradianceRecord more) {
    int at = NUMBERS * number;
    float own = numbers[at + RAYS] / (numbers[at + RAYS] + more.rays);
    for (int i = 0; i < 3; i++) {
      numbers[at + LIGHT + i] += (1 - own) * ((float) more.light[i] - numbers[at + LIGHT + i]);
    }
    for (int i = 0; i < 9; i++) {
      numbers[at + TURN + i] += (1 - own) * ((float) more.turn[i] - numbers[at + TURN + i]);
    }
    double a = own * numbers[at + ERROR];
    double b = (1 - own) * more.error;
    numbers[at + ERROR] = (float) Math.sqrt(a * a + b * b);
    numbers[at + RAYS] += more.rays;
    NearbyWallPlanes.join(numbers, at + WALLS, more.walls);
  }

  /**
   * Replaces the values of all records by denoised ones.
   *
   * @param others per record: error, irradiance and rotational gradient, in the order of this class
   */
  void even(float[] others) {
    int each = RAYS - ERROR;
    for (int i = 0; i < size; i++) {
      System.arraycopy(others, each * i, numbers, NUMBERS * i + ERROR, each);
    }
    evened = true;
  }

  void add(float[] block, int at, int group, int texel) {
    if (size == groups.length) {
      int more = Math.max(1024, size + size / 2);
      numbers = Arrays.copyOf(numbers, NUMBERS * more);
      groups = Arrays.copyOf(groups, more);
      texels = Arrays.copyOf(texels, more);
    }
    System.arraycopy(block, at, numbers, NUMBERS * size, NUMBERS);
    texels[size] = texel;
    groups[size++] = group;
  }

  /** Rebuilds the tree over all records. */
  void index() {
    float[] all = numbers;
    tree =
        BvhBuilder.build(
            size,
            (item, box) -> {
              int at = NUMBERS * item;
              float radius = all[at + RADIUS];
              for (int axis = 0; axis < 3; axis++) {
                box[axis] = all[at + axis] - radius;
                box[axis + 3] = all[at + axis] + radius;
              }
            });
  }
}
