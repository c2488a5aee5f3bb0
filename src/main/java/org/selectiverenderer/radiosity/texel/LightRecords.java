package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import org.selectiverenderer.geometry.tree.BoxTree;
import org.selectiverenderer.geometry.tree.BoxTreeBuilder;

/**
 * Light from surfaces at irregular places (Ward et al. 1988), each with a radius within which it
 * counts. Added to by one thread, then read by several.
 */
final class LightRecords {
  // Where the numbers of a record begin: place, normal, radius, error, light, turn, rays, whether
  // it is shaded flat, what stands near to it.
  static final int NORMAL = 3;
  static final int RADIUS = 6;
  static final int ERROR = 7;
  static final int LIGHT = 8;
  static final int TURN = 11;
  static final int RAYS = 20;
  static final int FLAT = 21;
  static final int WALLS = 22;
  static final int NUMBERS = WALLS + NearWalls.NUMBERS;

  private float[] numbers = new float[0];
  private int[] groups = new int[0];
  private int[] texels = new int[0];
  private int size;
  private boolean evened;
  private BoxTree tree = BoxTreeBuilder.build(0, (item, box) -> {});

  int size() {
    return size;
  }

  /** {@link #NUMBERS} by record; the first {@link #size} count. */
  float[] numbers() {
    return numbers;
  }

  /** By record; places of one group see the same surroundings. */
  int[] groups() {
    return groups;
  }

  /** By record: where it was gathered. */
  int[] texels() {
    return texels;
  }

  /** Whether their noise was taken out, so that what is left is the same in those side by side. */
  boolean evened() {
    return evened;
  }

  /** Boxes of the spheres within which the records count, as they were when it was last indexed. */
  BoxTree tree() {
    return tree;
  }

  /** Writes a record into a block of such. */
  static void write(TexelPlace place, double radius, LightRecord record, float[] block, int at) {
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
    System.arraycopy(record.walls, 0, block, at + WALLS, NearWalls.NUMBERS);
  }

  /** Takes the mean with what more rays from the same place have found; called once for each. */
  void join(int number, LightRecord more) {
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
    NearWalls.join(numbers, at + WALLS, more.walls);
  }

  /**
   * Takes what has become of all records.
   *
   * @param others by record: error, light, turn as they are here
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

  /** Makes the records that were added findable. */
  void index() {
    float[] all = numbers;
    tree =
        BoxTreeBuilder.build(
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
