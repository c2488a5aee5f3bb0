package org.selectiverenderer.validation.settings;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.validation.ValidationReport;

/**
 * A baseline: the findings of an earlier run, read from its JSON report, which are not reported
 * again. A finding is old if the baseline has one with the same rule, file, node and message, at
 * any line; if the baseline has one of two equal findings, the second is new.
 */
public final class Baseline {
  private record Key(String rule, String file, String node, String message) {}

  private final Map<Key, Integer> known = new HashMap<>();

  private Baseline() {}

  /** Returns an empty baseline. */
  public static Baseline none() {
    return new Baseline();
  }

  /**
   * Reads a report.
   *
   * @throws IOException if it cannot be read or is not a report, with a message of one line
   */
  public static Baseline read(Path file) throws IOException {
    JsonNode report = JsonTree.read(file);
    JsonNode issues = report.get("issues");
    if (issues == null || !issues.isArray()) {
      throw new IOException(file + ": is not a report of 'validate --format json'");
    }
    Baseline baseline = new Baseline();
    for (JsonNode issue : issues) {
      Key key =
          new Key(
              issue.path("rule").asText(),
              issue.path("file").asText(),
              issue.path("node").asText(),
              issue.path("message").asText());
      baseline.known.merge(key, 1, Integer::sum);
    }
    return baseline;
  }

  /** Returns the report without the findings of the baseline. */
  public ValidationReport without(ValidationReport report) {
    Map<Key, Integer> left = new HashMap<>(known);
    return new ValidationReport(
        report.files(),
        report.findings().stream()
            .filter(
                finding -> {
                  Key key =
                      new Key(
                          finding.rule().id(),
                          finding.location().file(),
                          finding.node(),
                          finding.message());
                  int rest = Optional.ofNullable(left.get(key)).orElse(0);
                  left.put(key, rest - 1);
                  return rest <= 0;
                })
            .toList(),
        report.dropped());
  }
}
