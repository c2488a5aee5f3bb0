package org.selectiverenderer.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import org.junit.jupiter.api.Test;

class GrowthTextReportTest {
  @Test
  void aTableForEachSeriesHasADashForWhatWasNotMeasured() throws IOException {
    String report =
        """
        {"growth": {
          "sensors": [{"size": 100000, "mb": 40.9, "load_ms": 1234.56, "load_cpu_ms": 2000,
            "heap_mb": 374.5, "frame_us": 2.6, "frame_p99_us": 6.3, "activation": {"us": 11.2}}],
          "objects": [{"size": 10, "fps": 12.5, "rss_mb": 300}]}}
        """;

    String text = GrowthTextReport.of(new ObjectMapper().readTree(report));

    assertThat(text.lines().map(line -> line.strip().replaceAll(" {2,}", " | ")))
        .contains(
            "100,000 | 40.9 | 1,234.6 | 2,000.0 | 374.5 | 2.6 | 6.3 | 11.2 | - | -",
            "10 | - | - | - | - | - | - | - | 12.5 | 300.0")
        .anyMatch(line -> line.startsWith("sensors | file: MB | load: ms"));
  }
}
