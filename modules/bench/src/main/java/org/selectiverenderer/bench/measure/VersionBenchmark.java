package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import org.selectiverenderer.bench.BenchScene;
import org.selectiverenderer.bench.GrowthSeries;
import org.selectiverenderer.bench.versions.VersionComparison;
import org.selectiverenderer.formats.json.JsonTree;

/** Compares rules for the choice of versions on the apartment and on a street of apartments. */
public final class VersionBenchmark {
  private static final int APARTMENTS = 4;

  private VersionBenchmark() {}

  /**
   * Measures both scenes.
   *
   * @return a report with an object {@code budget} of the scenes by name
   * @throws IOException if a scene cannot be written or read
   */
  public static ObjectNode run(VersionComparison comparison) throws IOException {
    ObjectNode report = JsonTree.object();
    ObjectNode scenes = report.putObject("budget");
    try (TemporaryFolder folder = new TemporaryFolder()) {
      BenchScene street = GrowthSeries.STREET.write(folder.path(), APARTMENTS);
      comparison.measure(
          street.scene().resolveSibling("apartment.x3d"),
          street.path(),
          scenes.putObject("apartment"));
      comparison.measure(street.scene(), street.path(), scenes.putObject("street"));
    }
    return report;
  }
}
