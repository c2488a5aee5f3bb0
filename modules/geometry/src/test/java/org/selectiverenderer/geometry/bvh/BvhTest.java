package org.selectiverenderer.geometry.bvh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** A thousand unit boxes in a row along X, box i centred at x = 10 i. */
class BvhTest {
  private final float[] centres = new float[1000];
  private final Bvh tree;

  BvhTest() {
    for (int i = 0; i < centres.length; i++) {
      centres[i] = 10 * i;
    }
    tree = BvhBuilder.build(centres.length, this::box);
  }

  private void box(int item, float[] out) {
    for (int axis = 0; axis < 3; axis++) {
      float centre = axis == 0 ? centres[item] : 0;
      out[axis] = centre - 0.5f;
      out[axis + 3] = centre + 0.5f;
    }
  }

  private TreeSet<Integer> tested(Vector3d origin) {
    TreeSet<Integer> tested = new TreeSet<>();
    tree.ray(
        origin,
        new Vector3d(0, -1, 0),
        Double.POSITIVE_INFINITY,
        (item, nearest) -> {
          tested.add(item);
          return nearest;
        });
    return tested;
  }

  @Test
  void aRayWithoutEndTestsOnlyWhatItMayMeet() {
    assertThat(tested(new Vector3d(5000, 9, 0))).contains(500).hasSizeLessThan(9);
    assertThat(tested(new Vector3d(5000, 9, 3))).isEmpty();
  }

  @Test
  void aBoxThatMovedIsFoundWhereItIsAndNotWhereItWas() {
    centres[500] = -300;
    tree.moved(500);
    assertThat(tested(new Vector3d(-300, 9, 0))).contains(500);
    TreeSet<Integer> found = new TreeSet<>();
    tree.overlap(new double[] {4995, -1, -1, 5005, 1, 1}, found::add);
    assertThat(found).hasSizeLessThan(9);
    tree.overlap(new double[] {-301, -1, -1, -299, 1, 1}, found::add);
    assertThat(found).contains(500);
  }

  @Test
  void aLargeTreeThatIsBuiltInParallelHasAllItemsInsideTheBoxesAboveThem() {
    int size = 100_000;
    Random random = new Random(3);
    float[] boxes = new float[6 * size];
    for (int i = 0; i < boxes.length; i += 6) {
      for (int axis = 0; axis < 3; axis++) {
        boxes[i + axis] = 100 * random.nextFloat();
        boxes[i + axis + 3] = boxes[i + axis] + random.nextFloat();
      }
    }
    Bvh large = BvhBuilder.build(size, (item, out) -> System.arraycopy(boxes, 6 * item, out, 0, 6));
    int[] seen = new int[size];
    large.search((of, at, leaf) -> true, item -> seen[item]++);
    assertThat(seen).containsOnly(1);
    for (int probe = 0; probe < 200; probe++) {
      int item = random.nextInt(size);
      double[] box = new double[6];
      for (int i = 0; i < 6; i++) {
        box[i] = boxes[6 * item + i];
      }
      boolean[] found = {false};
      large.overlap(box, other -> found[0] |= other == item);
      assertThat(found[0]).as("item %d", item).isTrue();
    }
    float rightmost =
        (float) large.greatest((of, at) -> of[at + 3], item -> boxes[6 * item + 3], 0);
    float expected = 0;
    for (int i = 3; i < boxes.length; i += 6) {
      expected = Math.max(expected, boxes[i]);
    }
    assertThat(rightmost).isEqualTo(expected);
    boxes[6] = -50;
    boxes[9] = 200;
    large.moved(1); // Refits along the parents of nodes of all parts.
    assertThat(large.boxes()[0]).isEqualTo(-50);
    assertThat(large.boxes()[3]).isEqualTo(200);
  }

  @Test
  void theGreatestIsFoundWithoutLookingAtMost() {
    int[] looks = {0};
    double farthest =
        tree.greatest(
            (boxes, at) -> boxes[at + 3],
            item -> {
              looks[0]++;
              return centres[item];
            },
            0);
    assertThat(farthest).isEqualTo(9990);
    assertThat(looks[0]).isLessThan(20);
    assertThat(tree.greatest((boxes, at) -> boxes[at + 3], item -> centres[item], 1e6))
        .isEqualTo(1e6);
  }

  @Test
  void groupsAreOfNeighboursAndHoldEachItemOnce() {
    List<int[]> groups = tree.groups(item -> item == 0 ? 1000 : 1, 100);
    List<Integer> all = new ArrayList<>();
    for (int[] group : groups) {
      IntSummaryStatistics range = IntStream.of(group).summaryStatistics();
      assertThat(range.getMax() - range.getMin()).isEqualTo(group.length - 1);
      assertThat(group.length).isBetween(1, 100);
      IntStream.of(group).forEach(all::add);
    }
    assertThat(all).hasSize(centres.length).doesNotHaveDuplicates();
    assertThat(groups).hasSizeLessThan(40);
    assertThat(BvhBuilder.build(0, this::box).groups(item -> 1, 10)).isEmpty();
  }

  @Test
  void anEmptyTreeFindsNothing() {
    Bvh empty = BvhBuilder.build(0, this::box);
    empty.overlap(new double[] {-1, -1, -1, 1, 1, 1}, item -> assertThat(item).isNegative());
  }
}
