package org.selectiverenderer.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.node.ArrayNode;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.formats.json.JsonTree;

/** The series are measured, and sizes that are too large for the heap are left out. */
class GrowthBenchmarkTest {
  private final ArrayNode rows = JsonTree.object().putArray("street");

  private void measured(int size, double heap) {
    rows.addObject().put("size", size).put("heap_mb", heap);
  }

  @Test
  void aSceneIsTooLargeIfItsHeapGrowsAsThatOfTheSmallerOnesDid() {
    measured(1, 40);
    measured(64, 200);
    measured(256, 800);

    assertThat(GrowthBenchmark.tooLarge(rows, 1_024, 4L << 30)).isEmpty();
    assertThat(GrowthBenchmark.tooLarge(rows, 1_024, 3L << 30))
        .hasValueSatisfying(
            reason ->
                assertThat(reason)
                    .startsWith("it takes about 3,200 MB of Java's heap, of which 2,458 MB"));
  }

  @Test
  void twoSmallerOnesTellAndWhatFollowsOneTooLargeIsTooLarge() {
    measured(1, 4_000);
    assertThat(GrowthBenchmark.tooLarge(rows, 16, 1L << 30)).isEmpty();

    rows.addObject().put("size", 16).put("skipped", "it takes about 64,000 MB");
    assertThat(GrowthBenchmark.tooLarge(rows, 64, 1L << 40)).isPresent();
  }
}
