package org.selectiverenderer.radiosity.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class TriangleStripBuilderTest {

  /** The triangles of strips, turned alike, in order. */
  private static List<List<Integer>> triangles(List<int[]> strips) {
    List<List<Integer>> all = new ArrayList<>();
    for (int[] strip : strips) {
      for (int i = 0; i + 2 < strip.length; i++) {
        int swap = i % 2;
        all.add(turned(strip[i + swap], strip[i + 1 - swap], strip[i + 2]));
      }
    }
    return sorted(all);
  }

  private static List<List<Integer>> triangles(int[] corners) {
    List<List<Integer>> all = new ArrayList<>();
    for (int i = 0; i < corners.length; i += 3) {
      all.add(turned(corners[i], corners[i + 1], corners[i + 2]));
    }
    return sorted(all);
  }

  /** Of the three ways to begin a triangle the one that sorts first. */
  private static List<Integer> turned(int a, int b, int c) {
    return sorted(new ArrayList<>(List.of(List.of(a, b, c), List.of(b, c, a), List.of(c, a, b))))
        .get(0);
  }

  private static List<List<Integer>> sorted(List<List<Integer>> all) {
    all.sort((x, y) -> x.toString().compareTo(y.toString()));
    return all;
  }

  /** Rows of squares, cut from lower left to upper right. */
  private static int[] grid(int side) {
    int[] corners = new int[6 * side * side];
    int at = 0;
    for (int row = 0; row < side; row++) {
      for (int column = 0; column < side; column++) {
        int a = row * (side + 1) + column;
        int d = a + side + 1;
        for (int vertex : new int[] {a, a + 1, d + 1, a, d + 1, d}) {
          corners[at++] = vertex;
        }
      }
    }
    return corners;
  }

  @Test
  void aRowOfSquaresIsOneStrip() {
    List<int[]> strips = TriangleStripBuilder.of(new int[] {0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5});

    assertThat(strips).hasSize(1);
    assertThat(strips.get(0)).hasSize(6);
    assertThat(triangles(strips))
        .isEqualTo(triangles(new int[] {0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5}));
  }

  @Test
  void aGridKeepsEveryTriangleAndTakesLessThanHalfOfTheNumbers() {
    int[] grid = grid(20);
    List<int[]> strips = TriangleStripBuilder.of(grid);

    assertThat(triangles(strips)).isEqualTo(triangles(grid));
    assertThat(strips.stream().mapToInt(strip -> strip.length + 1).sum())
        .isLessThan(grid.length / 2);
  }

  @Test
  void trianglesInAnyOrderWithAnyNeighboursAreKept() {
    Random random = new Random(7);
    for (int run = 0; run < 50; run++) {
      int[] corners = random.ints(90, 0, 12).toArray();
      assertThat(triangles(TriangleStripBuilder.of(corners))).isEqualTo(triangles(corners));
    }
  }

  @Test
  void nothingIsNoStrip() {
    assertThat(TriangleStripBuilder.of(new int[0])).isEmpty();
  }
}
