package org.selectiverenderer.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import org.junit.jupiter.api.Test;

class BenchmarkTextReportTest {
  private static final String REPORT =
      """
      {"machine": {"processor": "Abacus", "processors": 4, "java": "17"},
       "gl": {"renderer": "Pencil", "version": "4.5"},
       "read": {"mb_per_s": 51.2, "cold_mb_per_s": 20.1},
       "activation": {"us": 3.5, "affected": 10, "switches": 1000, "idle_frame_us": 0.1},
       "heavy": {"load_ms": 1234, "fps": 41.5, "rss_mb": 300, "process_to_first_frame_ms": 2345,
         "raw_fps": 50.5, "fps_to_raw": 0.82},
       "light": {"load_ms": 100, "fps": 400.5, "rss_mb": 200, "process_to_first_frame_ms": 999},
       "simplify": {"objects_ms": 2345.6, "objects": 50, "large_ms": 1234.5,
         "large_triangles": 1001112, "large_left": 100111},
       "versions": {
         "high": {"fps": 31.4, "frame_p50_ms": 30.2, "cpu_ms": 40, "vertex_ms": 20.5,
           "polygons_drawn": 300000,
           "polygons": 784002},
         "selective": {"fps": 88.2, "frame_p50_ms": 10.1, "cpu_ms": 20, "vertex_ms": 3.5,

           "polygons_drawn": 50123.4, "polygons": 130667},
         "bare": {"cpu_ms": 19.1, "vertex_ms": 4.4}},
       "apartment": {"kitchen": {
         "high": {"fps": 30.4, "polygons_drawn": 277224, "first_frame_ms": 800, "rss_mb": 512.6,
           "cpu_ms": 30, "vertex_ms": 8.25},
         "high-low": {"fps": 55.5, "polygons_drawn": 100000, "first_frame_ms": 801, "rss_mb": 513,
           "cpu_ms": 20.5, "vertex_ms": 4},
         "selective": {"fps": 60.8, "polygons_drawn": 49135, "first_frame_ms": 802, "rss_mb": 514,
           "cpu_ms": 18, "vertex_ms": 2.04},
         "selective_to_high": 2.0}}}
      """;

  private static final String APARTMENT =
      """
      simplify    2.35 s for the 50 objects of the apartment; 1.23 s for 1001112 triangles to 100111

      apartment, turning round                          high    high-low   selective
      kitchen, frames/s                                   30          56          61
      kitchen, polygons drawn                        277,224     100,000      49,135
      kitchen, processor time of a frame, ms            30.0        20.5        18.0
      kitchen, of that, vertices, ms                     8.3         4.0         2.0
      kitchen, first frame, ms                           800         801         802
      kitchen, MB                                        513         513         514
      kitchen: selective draws 2.0 times as many frames as high
      """;

  private static final String VERSIONS =
      """

      heavy scene, two versions of each object          high   selective       ratio
      frames/s                                          31.4        88.2        2.81
      frame, ms                                         30.2        10.1        0.33
      processor time of a frame, ms                     40.0        20.0        0.50
      of that, vertices, ms                             20.5         3.5        0.17
      polygons drawn                                 300,000      50,123        0.17
      polygons of the scene                          784,002     130,667        0.17
      with a hundredth of the polygons: 19.1 ms of processor time, of that vertices 4.4 ms
      """;

  private final ObjectMapper json = new ObjectMapper();

  private static String text(JsonNode report) {
    return BenchmarkTextReport.of(report).replace(System.lineSeparator(), "\n");
  }

  @Test
  void theMachineComesFirstAndTheApartmentLast() throws IOException {
    String text = text(json.readTree(REPORT));

    assertThat(text)
        .startsWith("machine     Abacus, 4 processors\njava        17\nOpenGL      Pencil, 4.5\n")
        .contains("reading     51.2 MB/s over all processors (20.1 MB/s cold)\n")
        .contains("activation  3.5 us for a frame in which 10 of 1000 switches change")
        .contains(
            "yardstick   heavy scene: 50.5 frames/s of all triangles in one raw call; ours are 0.82")
        .containsPattern("from the start of reading\\) +1.23 +41.5 +300 +0.10 +400.5 +200\n")
        .containsPattern("from process start\\) +2.35 +1.00 +\n")
        .endsWith(VERSIONS + "\n" + APARTMENT);
  }

  @Test
  void withoutTheApartmentThereIsNothingOfIt() throws IOException {
    JsonNode report = json.readTree(REPORT.replaceAll("\"(apartment|versions)\"", "\"other\""));

    assertThat(text(report))
        .doesNotContain("apartment", "versions of")
        .endsWith("compare with care.\n");
  }
}
