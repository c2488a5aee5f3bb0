package org.selectiverenderer.validation.report;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.validation.Finding;
import org.selectiverenderer.validation.ValidationReport;

/**
 * Writes the report in the JSON format of {@code report.schema.json}, which {@code --baseline}
 * reads too.
 */
final class JsonReportWriter {
  private JsonReportWriter() {}

  static String of(ValidationReport report) {
    return JsonWriter.of(json -> write(report, json));
  }

  private static void write(ValidationReport report, JsonGenerator json) throws IOException {
    json.writeStartObject();
    json.writeArrayFieldStart("issues");
    for (Finding finding : report.findings()) {
      json.writeStartObject();
      json.writeStringField("rule", finding.rule().id());
      json.writeStringField("severity", ReportPhrases.of(finding.severity()));
      json.writeStringField("file", finding.location().file());
      json.writeNumberField("line", finding.location().line());
      json.writeNumberField("column", finding.location().column());
      json.writeStringField("node", finding.node());
      json.writeStringField("message", finding.message());
      json.writeEndObject();
    }
    json.writeEndArray();
    json.writeObjectFieldStart("summary");
    json.writeNumberField("files", report.files().size());
    json.writeNumberField("errors", report.count(Severity.ERROR));
    json.writeNumberField("warnings", report.count(Severity.WARNING));
    json.writeNumberField("infos", report.count(Severity.INFO));
    if (report.dropped() > 0) {
      json.writeNumberField("dropped", report.dropped());
    }
    json.writeEndObject();
    json.writeEndObject();
  }
}
