package org.selectiverenderer.validation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;
import org.selectiverenderer.validation.settings.ValidationSettingsReader;

/**
 * Every rule has the smallest scene that breaks it and one that does not. What is found in {@code
 * ID-error.x3d} stands beside it in {@code ID-error.report}: this, and nothing else, is found.
 *
 * <p>With {@code -Dfixtures.write=true} the reports are written instead; read what changed before
 * committing it.
 */
class RuleFixturesTest {
  private static final Path FOLDER =
      Path.of("modules/validation/src/test/resources/org/selectiverenderer/validation/fixtures");

  /** The folder as the reports write it, on Windows too. */
  private static final String REPORTED_FOLDER = FOLDER.toString().replace('\\', '/') + "/";

  // ID-severity, and a word where a rule has several fixtures.
  private static final Pattern NAME =
      Pattern.compile("(SR\\d{3})-(error|warning|info|valid)(-[a-z0-9-]+)?\\.x3dz?");

  static Stream<String> fixtures() throws IOException {
    try (Stream<Path> files = Files.list(FOLDER)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> NAME.matcher(name).matches())
          .sorted()
          .toList()
          .stream();
    }
  }

  @ParameterizedTest
  @MethodSource("fixtures")
  void hasExactlyTheFindingsOfItsReport(String name) throws IOException {
    Matcher matcher = NAME.matcher(name);
    assertThat(matcher.matches()).isTrue();
    List<Finding> findings = validate(name).findings();

    assertThat(findings).allMatch(finding -> finding.rule().id().equals(matcher.group(1)));
    if (matcher.group(2).equals("valid")) {
      assertThat(text(findings)).isEmpty();
      return;
    }
    Severity severity = Severity.valueOf(matcher.group(2).toUpperCase(Locale.ROOT));
    assertThat(findings).isNotEmpty().allMatch(finding -> finding.severity() == severity);
    Path report = FOLDER.resolve(name.replaceAll("\\.x3dz?$", ".report"));
    if (Boolean.getBoolean("fixtures.write")) {
      Files.writeString(report, text(findings), StandardCharsets.UTF_8);
    }
    assertThat(text(findings)).isEqualTo(Files.readString(report, StandardCharsets.UTF_8));
  }

  @Test
  void everyRuleHasABadAndAValidFixture() throws IOException {
    List<String> names = fixtures().toList();
    for (Rule rule : RuleCatalogue.standard().rules()) {
      if (rule.id().equals("SR309")) {
        continue; // Git keeps no file that may not be read: UnreadableFileTest.
      }
      if (rule.id().equals("SR208")) {
        continue; // found by the enricher only: GeometryProblemsTest
      }
      String bad = rule.id() + "-" + rule.severity().name().toLowerCase(Locale.ROOT);
      assertThat(names).as(bad).anyMatch(name -> name.startsWith(bad));
      String valid = rule.id() + "-valid";
      assertThat(names).as(valid).anyMatch(name -> name.startsWith(valid));
    }
  }

  @Test
  void everyReportHasItsFixture() throws IOException {
    List<String> names = fixtures().map(name -> name.replaceAll("\\.x3dz?$", "")).toList();
    try (Stream<Path> files = Files.list(FOLDER)) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .filteredOn(name -> name.endsWith(".report"))
          .allMatch(name -> names.contains(name.replace(".report", "")));
    }
  }

  private static ValidationReport validate(String name) throws IOException {
    Path settings = FOLDER.resolve(name.replaceAll("\\.x3dz?$", ".json"));
    RuleCatalogue rules = RuleCatalogue.standard();
    return new Validator(
            rules,
            Files.exists(settings)
                ? new ValidationSettingsReader(settings, rules)
                    .read(new ProblemCollector())
                    .orElseThrow()
                : ValidationSettings.standard(),
            FOLDER)
        .validate(List.of(SourceFile.of(FOLDER.resolve(name), FOLDER)));
  }

  private static String text(List<Finding> findings) {
    return findings.stream()
        .map(
            finding ->
                finding.location()
                    + ": "
                    + finding.rule().id()
                    + (finding.node().isEmpty() ? "" : " [" + finding.node() + "]")
                    + " "
                    + finding.message().replace(FOLDER + File.separator, REPORTED_FOLDER)
                    + "\n")
        .collect(Collectors.joining());
  }
}
