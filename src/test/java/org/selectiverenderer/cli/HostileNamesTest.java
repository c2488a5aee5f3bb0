package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.formats.json.JsonTree;

/** Names and texts of strangers, in what commands print for people and programs. */
class HostileNamesTest extends CommandTestCase {
  private static final Path LISTS = Path.of("src/test/resources/hostile/names");
  private static final String PATH = "scenes/paths/desk-visit.csv";

  @TempDir Path folder;

  private static List<String> list(String name) throws IOException {
    return Files.readAllLines(LISTS.resolve(name)).stream()
        .filter(line -> !line.startsWith("# "))
        .map(
            line ->
                Pattern.compile("\\\\u([0-9a-f]{4})")
                    .matcher(line)
                    .replaceAll(code -> quoted((char) Integer.parseInt(code.group(1), 16))))
        .toList();
  }

  private static String quoted(char character) {
    return java.util.regex.Matcher.quoteReplacement(String.valueOf(character));
  }

  private Path scene(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text);
  }

  private void assertHarmless() {
    for (String text : List.of(printed(), messages())) {
      assertThat(text.lines())
          .noneMatch(line -> line.chars().anyMatch(ControlCharacterEscaper::isControl));
    }
  }

  /** The files that this system can have. */
  private List<Path> files() throws IOException {
    List<Path> made = new ArrayList<>();
    for (String name : list("files.txt")) {
      try {
        made.add(scene(name, "<X3D profile='Immersive' version='4.0'><Scene><Bx/></Scene></X3D>"));
      } catch (InvalidPathException | IOException e) {
        // A name that Windows does not have.
      }
    }
    assertThat(made).isNotEmpty();
    return made;
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "no name holds a line end there")
  void namesOfFilesForgeNothing() throws IOException {
    int count = files().size();
    for (String format : List.of("text", "github", "sarif", "junit", "json")) {
      execute("validate", folder.toString(), "--format", format);
      assertHarmless();
      if (format.equals("github")) {
        assertThat(printed().lines())
            .hasSizeGreaterThanOrEqualTo(count)
            .allMatch(line -> line.matches("::(error|warning|notice) file=[^,:]*,line=.*"));
      } else if (format.equals("json") || format.equals("sarif")) {
        JsonNode report = JsonTree.parse(printed());
        assertThat(report.toString()).containsAnyOf("a\\n::warning::forged.x3d", "a%0A");
      } else if (format.equals("text")) {
        assertThat(printed().lines()).noneMatch(line -> line.strip().startsWith("::"));
      }
    }
    execute("validate", folder.resolve("gone\n::error::x\u001b[2J.x3d").toString());
    assertHarmless();
    assertThat(messages().lines()).noneMatch(line -> line.startsWith("::"));
  }

  @Test
  void textsOfScenesCommandNoTerminal() throws IOException {
    String plain =
        Files.readString(Path.of("scenes/trashcan.x3d"))
            .replace("../inlineNodes", Path.of("inlineNodes").toUri().toString());
    for (String text : list("texts.txt").subList(0, 6)) {
      String escaped = MarkupEscaper.attribute(text).replace("'", "&apos;");
      Path scene =
          scene(
              "scene.x3d",
              plain
                  .replace("DeskSchema", escaped)
                  .replace("'Switch_TrashCan'", "'" + escaped + "'")
                  .replace("description='Office'", "description='" + escaped + "&#10;forged'"));
      execute("run", scene.toString(), "--viewpoints");
      assertHarmless();
      assertThat(printed()).contains("OfficeView");
      assertThat(printed().lines()).noneMatch("forged"::equals);
      for (String format : List.of("text", "json", "csv")) {
        execute("polygons", scene.toString(), "--format", format);
        assertHarmless();
        assertThat(printed()).isNotEmpty();
        if (format.equals("json")) {
          assertThat(JsonTree.parse(printed()).toString()).contains(text.replace("\u007f", ""));
        }
      }
    }
    execute("simulate", folder.resolve("scene.x3d").toString(), "--path", PATH);
    assertHarmless();
    assertThat(printed()).contains("switch");
  }

  @Test
  void namesTooLongForFileSystemsEnd() throws IOException {
    String ball =
        Files.readString(Path.of("inlineNodes/trashCan_v1.x3d"))
            .replaceFirst("<Scene>", "<Scene><Group DEF='" + "D".repeat(243) + "'>")
            .replace("</Scene>", "</Group></Scene>");
    String scene = scene("scene.x3d", ball).toString();
    int status =
        assertTimeoutPreemptively(
            Duration.ofSeconds(60),
            () -> execute("versions", scene, "--object", "D".repeat(243), "--polygons", "500"));
    assertThat(status).as(messages()).isLessThan(2);
    String target = folder.resolve("a".repeat(300) + ".x3d").toString();
    assertThat(
            assertTimeoutPreemptively(
                Duration.ofSeconds(60), () -> execute("convert", scene, target)))
        .isEqualTo(2);
    assertThat(messages()).hasLineCount(1);
  }

  @Test
  @EnabledOnOs({OS.LINUX, OS.MAC})
  void devicesAreNoRecordings() {
    for (String[] command :
        List.of(
            new String[] {"track", "replay:/dev/zero", "--duration", "1"},
            new String[] {"simulate", "scenes/trashcan.x3d", "--path", "/dev/zero"},
            new String[] {"experiment", "view", "/dev/zero"},
            new String[] {"experiment", "status", "/dev/zero"})) {
      assertThat(assertTimeoutPreemptively(Duration.ofSeconds(60), () -> execute(command)))
          .isEqualTo(2);
      assertThat(messages()).contains("/dev/zero", "a device or a pipe");
    }
  }
}
