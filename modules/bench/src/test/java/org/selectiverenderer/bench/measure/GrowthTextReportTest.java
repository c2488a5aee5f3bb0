package org.selectiverenderer.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class GrowthTextReportTest {
  private static String text(String report) throws IOException {
    return GrowthTextReport.of(new ObjectMapper().readTree(report))
        .lines()
        .map(line -> line.strip().replaceAll(" {2,}", " | "))
        .collect(Collectors.joining("\n", "", "\n"));
  }

  @Test
  void aTableForEachSeriesHasADashForWhatWasNotMeasured() throws IOException {
    String text =
        text(
            """
            {"growth": {
              "sensors": [{"size": 100000, "mb": 40.9, "load_ms": 1234.56, "load_cpu_ms": 2000,
                "heap_mb": 374.5, "frame_us": 2.6, "frame_p99_us": 6.3, "activation": {"us": 11.2}}],
              "objects": [{"size": 10, "fps": 12.5, "rss_mb": 300}]}}
            """);

    assertThat(text)
        .contains(
            "100,000 | 40.9 | 1,234.6 | 2,000.0 | 374.5 | 2.6 | 6.3 | 11.2 | - | -\n",
            "10 | - | - | - | - | 12.5 | 300.0 | - | -\n",
            "sensors | file: MB | load: ms");
  }

  @Test
  void aStreetShowsWhatIsDrawnAndWhereItEnds() throws IOException {
    String text =
        text(
            """
            {"growth": {"street": [
              {"size": 64, "mb": 29.5, "load_ms": 900.5, "load_cpu_ms": 1500, "heap_mb": 210.4,
                "enriched": 3200, "polygons": 9207488, "frame_us": 7.5, "frame_p99_us": 20.1,
                "activation": {"us": 412.5, "changed": 320}, "fps": 61.5, "frame_p50_ms": 9.12,
                "frame_p95_ms": 20.5, "loaded_ms": 1234.5, "first_frame_ms": 2345.6,
                "polygons_drawn": 7929.6, "rss_mb": 512.4},
              {"size": 256, "mb": 29.6, "heap_mb": 800, "undrawn": "no memory"},
              {"size": 1024, "skipped": "it takes about 3,200 MB"}]}}
            """);

    assertThat(text)
        .startsWith(
            """
            street | file: MB | load: ms | CPU: ms | heap: MB | frame: us | 99 %: us | change: us \
            | changed | enriched
            64 | 29.5 | 900.5 | 1,500.0 | 210.4 | 7.5 | 20.1 | 412.5 | 320 | 3,200
            256 | 29.6 | - | - | 800.0 | - | - | - | - | -
            1,024 not measured: it takes about 3,200 MB
            drawn | load: s | first: s | p50: ms | p95: ms | frames/s | MB | polygons | drawn
            64 | 1.23 | 2.35 | 9.1 | 20.5 | 61.5 | 512.4 | 9,207,488 | 7,930
            256 not drawn: no memory
            """);
  }
}
