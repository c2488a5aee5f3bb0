package org.selectiverenderer.validation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.validation.report.ReportFormat;
import org.selectiverenderer.validation.report.SarifReportWriter;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;
import org.selectiverenderer.validation.settings.Baseline;

/** Tests the limits on findings of one rule in one file, in reports and in memory. */
class ManyFindingsTest {
  private static final ReportFormat.Style STYLE =
      new ReportFormat.Style(false, Severity.ERROR, "1");

  @TempDir Path folder;

  @Test
  void whatIsSuppressedTakesNoPlaceOfWhatIsNot() throws IOException {
    String scene = "<!-- validate-ignore SR101 -->\n<Group>" + slips(60) + "</Group>\n" + slips(7);
    assertThat(validate(scene).findings()).hasSize(7);
    assertThat(
            validate(slips(60), ValidationSettings.standard().ignoring(Set.of("SR101"))).findings())
        .isEmpty();
  }

  @Test
  void ofSuppressionsWithinEachOtherEachCounts() throws IOException {
    String scene =
        """
        <!-- validate-ignore SR101 -->
        <Group>
          <!-- validate-ignore SR135 -->
          <Group><Slip/><Group DEF='a b'/></Group>
          <!-- validate-ignore SR102 -->
          <Group/>
          <Slip/><Group DEF='c d'/>
        </Group>
        <Slip/><Group DEF='e f'/>
        """;
    assertThat(validate(scene).findings())
        .extracting(finding -> finding.location().line() + " " + finding.rule().id())
        .containsExactly("9 SR135", "11 SR101", "11 SR135");
  }

  @Test
  void allOfThemAreInABaseline() throws IOException {
    Path old = folder.resolve("old.json");
    ValidationReport first = validate(slips(120));
    Files.writeString(old, ReportFormat.JSON.write(first, STYLE));
    assertThat(first.findings()).hasSize(120);
    assertThat(Baseline.read(old).without(first).findings()).isEmpty();
    assertThat(Baseline.read(old).without(validate(slips(123))).findings()).hasSize(3);
  }

  @Test
  void theirTextDoesNotDependOnHowManyThereAre() throws IOException {
    List<Finding> few = validate(slips(20)).findings();
    List<Finding> many = validate(slips(200)).findings();
    assertThat(many.subList(0, 20)).isEqualTo(few);
    assertThat(many).extracting(Finding::message).containsOnly(few.get(0).message());
    assertThat(SarifReportWriter.Fingerprints.of(many).subList(0, 20))
        .isEqualTo(SarifReportWriter.Fingerprints.of(few));
  }

  @Test
  void textListsFiftyAndCountsTheRest() throws IOException {
    String text = ReportFormat.TEXT.write(validate(slips(60)), STYLE);
    assertThat(text.split("\\[SR101]", -1)).hasSize(51);
    assertThat(text)
        .contains("s.x3d: 10 more of SR101 are not listed (--format json lists all)")
        .endsWith("1 file: 60 errors, 0 warnings, 0 remarks\n");
    assertThat(ReportFormat.TEXT.write(validate(slips(50)), STYLE)).doesNotContain("not listed");
  }

  @Test
  void beyondTenThousandTheyAreOnlyCounted() throws IOException {
    ValidationReport report = validate(slips(FindingCollector.LIMIT + 5));
    assertThat(report.findings()).hasSize(FindingCollector.LIMIT);
    assertThat(report.dropped()).isEqualTo(5);
    for (ReportFormat format : ReportFormat.values()) {
      String expected =
          format == ReportFormat.JSON
              ? "\"dropped\" : 5"
              : "5 findings are not reported: more than 10000 of one rule in one file";
      assertThat(format.write(report, STYLE)).as(format.name()).contains(expected);
    }
  }

  private static String slips(int count) {
    return "<Slip/>".repeat(count);
  }

  private static ValidationReport validate(String nodes) throws IOException {
    return validate(nodes, ValidationSettings.standard());
  }

  private static ValidationReport validate(String nodes, ValidationSettings settings)
      throws IOException {
    String scene =
        "<?xml version='1.0'?>\n<X3D profile='Full' version='4.0'><Scene>\n"
            + nodes
            + "</Scene></X3D>";
    Path base = Path.of("");
    return new Validator(RuleCatalogue.standard(), settings, base)
        .validate(
            List.of(
                SourceFile.of(
                    base.resolve("s.x3d"), "s.x3d", scene.getBytes(StandardCharsets.UTF_8))));
  }
}
