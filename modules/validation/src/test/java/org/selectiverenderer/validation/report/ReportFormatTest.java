package org.selectiverenderer.validation.report;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion.VersionFlag;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.validation.ValidationReport;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.SceneFinder;
import org.selectiverenderer.validation.run.Validator;

/**
 * One folder of scenes in every format, byte for byte. With {@code -Dfixtures.write=true} the
 * reports are written instead; read what changed before committing it.
 */
class ReportFormatTest {
  private static final Path FOLDER =
      Path.of("modules/validation/src/test/resources/org/selectiverenderer/validation/reports");
  private static final ReportFormat.Style STYLE =
      new ReportFormat.Style(false, Severity.ERROR, "1.2.3");

  @ParameterizedTest
  @EnumSource
  void isTheGoldenReport(ReportFormat format) throws IOException {
    Path golden = FOLDER.resolve("report." + format.name().toLowerCase(Locale.ROOT));
    String report = format.write(validate(), STYLE);
    if (Boolean.getBoolean("fixtures.write")) {
      Files.writeString(golden, report, StandardCharsets.UTF_8);
    }
    assertThat(report).isEqualTo(Files.readString(golden, StandardCharsets.UTF_8));
  }

  @ParameterizedTest
  @EnumSource
  void isTheSameInEveryLocaleAndEndsItsLinesByLineFeeds(ReportFormat format) throws IOException {
    Locale before = Locale.getDefault();
    String here = format.write(validate(), STYLE);
    try {
      Locale.setDefault(Locale.forLanguageTag("tr-TR"));
      assertThat(format.write(validate(), STYLE)).isEqualTo(here).doesNotContain("\r");
    } finally {
      Locale.setDefault(before);
    }
  }

  @Test
  void jsonFollowsThePublishedSchema() throws IOException {
    ObjectMapper mapper = new ObjectMapper();
    JsonNode report = mapper.readTree(ReportFormat.JSON.write(validate(), STYLE));
    try (InputStream in =
        Objects.requireNonNull(ReportFormat.class.getResourceAsStream("report.schema.json"))) {
      JsonSchema schema =
          JsonSchemaFactory.getInstance(VersionFlag.V202012).getSchema(mapper.readTree(in));
      assertThat(schema.validate(report)).isEmpty();
      assertThat(schema.validate(mapper.readTree("{\"issues\":[{}],\"summary\":{}}"))).isNotEmpty();
    }
  }

  @Test
  void junitIsWellFormedXmlWithATestForEachFile() throws Exception {
    String xml = ReportFormat.JUNIT.write(validate(), STYLE);
    var document =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)));
    assertThat(document.getElementsByTagName("testcase").getLength()).isEqualTo(3);
    assertThat(document.getElementsByTagName("failure").getLength()).isEqualTo(2);
  }

  @Test
  void coloursAreForTerminalsOnly() throws IOException {
    ReportFormat.Style colours = new ReportFormat.Style(true, Severity.ERROR, "1.2.3");
    String coloured = ReportFormat.TEXT.write(validate(), colours);
    assertThat(coloured).contains("\u001b[1;31merror:\u001b[0m");
    assertThat(coloured.replaceAll("\u001b\\[[0-9;]*m", ""))
        .isEqualTo(ReportFormat.TEXT.write(validate(), STYLE));
  }

  private static ValidationReport validate() throws IOException {
    SceneFinder finder = new SceneFinder(FOLDER, InputStream.nullInputStream());
    return new Validator(RuleCatalogue.standard(), ValidationSettings.standard(), FOLDER)
        .validate(List.copyOf(finder.find(FOLDER.resolve("scenes").toString())));
  }
}
