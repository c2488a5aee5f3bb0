package org.selectiverenderer.validation.report;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.validation.Finding;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.ValidationReport;

/** Writes the report as SARIF 2.1.0 (OASIS): the violated rules, and a result for each finding. */
public final class SarifReportWriter {
  private static final String SCHEMA =
      "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

  private final ValidationReport report;
  private final List<Rule> rules;

  private SarifReportWriter(ValidationReport report) {
    this.report = report;
    this.rules =
        report.findings().stream()
            .map(Finding::rule)
            .distinct()
            .sorted(java.util.Comparator.comparing(Rule::id))
            .toList();
  }

  static String of(ValidationReport report, ReportFormat.Style style) {
    return JsonWriter.of(json -> new SarifReportWriter(report).write(json, style.version()));
  }

  private void write(JsonGenerator json, String version) throws IOException {
    json.writeStartObject();
    json.writeStringField("$schema", SCHEMA);
    json.writeStringField("version", "2.1.0");
    json.writeArrayFieldStart("runs");
    json.writeStartObject();
    json.writeObjectFieldStart("tool");
    json.writeObjectFieldStart("driver");
    json.writeStringField("name", "selective-renderer validate");
    json.writeStringField("semanticVersion", version);
    json.writeArrayFieldStart("rules");
    for (Rule rule : rules) {
      write(json, rule);
    }
    json.writeEndArray();
    json.writeEndObject();
    json.writeEndObject();
    if (report.dropped() > 0) {
      invocation(json);
    }
    json.writeStringField("columnKind", "utf16CodeUnits");
    json.writeArrayFieldStart("results");
    List<String> fingerprints = Fingerprints.of(report.findings());
    for (int i = 0; i < fingerprints.size(); i++) {
      write(json, report.findings().get(i), fingerprints.get(i));
    }
    json.writeEndArray();
    json.writeEndObject();
    json.writeEndArray();
    json.writeEndObject();
  }

  private void invocation(JsonGenerator json) throws IOException {
    json.writeArrayFieldStart("invocations");
    json.writeStartObject();
    json.writeBooleanField("executionSuccessful", true);
    json.writeArrayFieldStart("toolExecutionNotifications");
    json.writeStartObject();
    json.writeStringField("level", "warning");
    text(json, "message", ReportPhrases.dropped(report));
    json.writeEndObject();
    json.writeEndArray();
    json.writeEndObject();
    json.writeEndArray();
  }

  private static void write(JsonGenerator json, Rule rule) throws IOException {
    json.writeStartObject();
    json.writeStringField("id", rule.id());
    text(json, "shortDescription", rule.title());
    text(json, "fullDescription", rule.explanation());
    text(json, "help", rule.explanation() + "\nSource: " + rule.reference());
    json.writeObjectFieldStart("defaultConfiguration");
    json.writeStringField("level", level(rule.severity()));
    json.writeEndObject();
    json.writeEndObject();
  }

  private void write(JsonGenerator json, Finding finding, String fingerprint) throws IOException {
    SourceLocation at = finding.location();
    json.writeStartObject();
    json.writeStringField("ruleId", finding.rule().id());
    json.writeNumberField("ruleIndex", rules.indexOf(finding.rule()));
    json.writeStringField("level", level(finding.severity()));
    text(json, "message", finding.message());
    json.writeArrayFieldStart("locations");
    json.writeStartObject();
    json.writeObjectFieldStart("physicalLocation");
    json.writeObjectFieldStart("artifactLocation");
    json.writeStringField("uri", uri(at.file()));
    json.writeEndObject();
    if (at.line() > 0) {
      json.writeObjectFieldStart("region");
      json.writeNumberField("startLine", at.line());
      if (at.column() > 0) {
        json.writeNumberField("startColumn", at.column());
      }
      json.writeEndObject();
    }
    json.writeEndObject();
    if (!finding.node().isEmpty()) {
      json.writeArrayFieldStart("logicalLocations");
      json.writeStartObject();
      json.writeStringField("name", finding.node());
      json.writeEndObject();
      json.writeEndArray();
    }
    json.writeEndObject();
    json.writeEndArray();
    json.writeObjectFieldStart("partialFingerprints");
    json.writeStringField("selectiveRenderer/v1", fingerprint);
    json.writeEndObject();
    json.writeEndObject();
  }

  private static void text(JsonGenerator json, String key, String text) throws IOException {
    json.writeObjectFieldStart(key);
    json.writeStringField("text", text);
    json.writeEndObject();
  }

  private static String level(Severity severity) {
    return severity == Severity.INFO ? "note" : ReportPhrases.of(severity);
  }

  /**
   * Returns a relative reference (RFC 3986, 4.2). A colon is escaped, since {@code a:b.x3d} would
   * begin with a scheme; non-ASCII letters are encoded as in the file name, without Unicode
   * normalisation.
   */
  private static String uri(String file) {
    StringBuilder uri = new StringBuilder();
    for (byte b : file.getBytes(StandardCharsets.UTF_8)) {
      char c = (char) (b & 0xff);
      if (c < 128 && (Character.isLetterOrDigit(c) || "/-._~!$&'()*+,;=@".indexOf(c) >= 0)) {
        uri.append(c);
      } else {
        uri.append('%').append(HexFormat.of().withUpperCase().toHexDigits(b));
      }
    }
    return uri.toString();
  }

  /**
   * Computes fingerprints of findings, which stay the same when lines move, so that other programs
   * can distinguish old findings from new ones. A fingerprint is a hash of rule, file, node and
   * message, and of the number of equal findings before it.
   */
  public static final class Fingerprints {
    private static final int DIGITS = 32;

    private Fingerprints() {}

    /** Returns a fingerprint for each finding, in their order: 32 hexadecimal digits. */
    public static List<String> of(List<Finding> findings) {
      Map<String, Integer> before = new HashMap<>();
      List<String> prints = new ArrayList<>(findings.size());
      for (Finding finding : findings) {
        String text =
            String.join(
                "\n",
                finding.rule().id(),
                finding.location().file(),
                finding.node(),
                finding.message());
        int number = before.merge(text, 1, Integer::sum);
        String hash = Sha256.of((text + "\n" + number).getBytes(StandardCharsets.UTF_8));
        prints.add(hash.substring(0, DIGITS));
      }
      return prints;
    }
  }
}
