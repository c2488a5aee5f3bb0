package org.selectiverenderer.geometry.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

class EdgeKeyTest {
  @Test
  void aKeyTellsItsEdgeAndNoOther() {
    int[] points = {0, 1, 2, 77_777, Integer.MAX_VALUE, -1};
    Set<Long> keys = new HashSet<>();
    for (int from : points) {
      for (int to : points) {
        long key = EdgeKey.of(from, to);
        assertThat(keys.add(key)).isTrue();
        assertThat(EdgeKey.from(key)).isEqualTo(from);
        assertThat(EdgeKey.to(key)).isEqualTo(to);
      }
    }
  }

  /** A table finds its places by hash codes. */
  @Test
  void edgesBetweenNearNumbersHaveHashCodesOfTheirOwn() {
    Set<Integer> codes = new HashSet<>();
    for (int i = 0; i < 1000; i++) {
      for (int step = 1; step < 10; step++) {
        codes.add(Long.hashCode(EdgeKey.of(i, i + step)));
      }
    }
    assertThat(codes).hasSizeGreaterThan(8990);
  }
}
