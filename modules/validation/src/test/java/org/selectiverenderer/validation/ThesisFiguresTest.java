package org.selectiverenderer.validation;

import static org.assertj.core.api.Assertions.assertThat;

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
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;

/**
 * The figures of the thesis that show markup, typed in as printed, get the findings that
 * docs/thesis-figures.md lists, and no others. With {@code -Dfixtures.write=true} the lists of the
 * page are written instead; read what changed before committing it.
 */
class ThesisFiguresTest {
  private static final Path FIGURES =
      Path.of("modules/validation/src/test/resources/org/selectiverenderer/validation/figures");
  private static final Path PAGE = Path.of("docs/thesis-figures.md");
  private static final Path TRASH_CAN = Path.of("inlineNodes");

  @TempDir Path folder;

  static Stream<String> figures() throws IOException {
    try (Stream<Path> files = Files.list(FIGURES)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList().stream();
    }
  }

  @ParameterizedTest
  @MethodSource("figures")
  void getsTheFindingsThatThePageLists(String name) throws IOException {
    String found = findings(name);
    String page = Files.readString(PAGE, StandardCharsets.UTF_8);
    Matcher list =
        Pattern.compile(
                "(<!-- " + Pattern.quote(name) + " -->\n```text\n)(.*?)(```\n)", Pattern.DOTALL)
            .matcher(page);
    assertThat(list.find()).as("list of %s in %s", name, PAGE).isTrue();
    if (Boolean.getBoolean("fixtures.write")) {
      Files.writeString(
          PAGE, page.substring(0, list.start(2)) + found + page.substring(list.end(2)));
    } else {
      assertThat(found).isEqualTo(list.group(2));
    }
  }

  @Test
  void theMisspeltSetOfFigure47LeavesTheSensorWithoutSchemas() throws IOException {
    assertThat(findings("fig47.x3d"))
        .contains("SR101 X3D 4.0 has no element MetadatSet; did you mean MetadataSet?")
        .contains("SR426 the sensor names no schema");
  }

  @Test
  void figure52ContradictsItsText() throws IOException {
    assertThat(findings("fig52.x3d"))
        .contains("SR416 choice 0 is more consistent than choice 1, but has more polygons: 1,064");
  }

  /** The files of the trash can are in the place that the figures name. */
  private String findings(String name) throws IOException {
    Path inlined = Files.createDirectories(folder.resolve("inlineNodes"));
    for (String version : List.of("trashCan_v1.x3d", "trashCan_v2.x3d")) {
      Files.copy(TRASH_CAN.resolve(version), inlined.resolve(version));
    }
    Path figure = Files.copy(FIGURES.resolve(name), folder.resolve(name));
    ValidationReport report =
        new Validator(RuleCatalogue.standard(), ValidationSettings.standard(), folder)
            .validate(List.of(SourceFile.of(figure, folder)));
    return report.findings().stream().map(ThesisFiguresTest::line).collect(Collectors.joining());
  }

  private static String line(Finding finding) {
    return "%s %s: %s %s\n"
        .formatted(
            finding.location(),
            finding.severity().name().toLowerCase(Locale.ROOT),
            finding.rule().id(),
            finding.message());
  }
}
