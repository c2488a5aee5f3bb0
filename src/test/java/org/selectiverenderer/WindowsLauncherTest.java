package org.selectiverenderer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** What can be said of the launcher for Windows by reading it. */
class WindowsLauncherTest {
  private static final Pattern QUOTED = Pattern.compile("\"[^\"]*\"");

  private static String text() throws IOException {
    return Files.readString(Path.of("selective-renderer.cmd"));
  }

  private static List<String> lines() throws IOException {
    return text().lines().toList();
  }

  /** A parenthesis in a folder's name or in an argument would end a block where it stands. */
  @Test
  void hasNoBlocks() throws IOException {
    assertThat(lines())
        .filteredOn(line -> !line.startsWith("rem "))
        .allSatisfy(line -> assertThat(QUOTED.matcher(line).replaceAll("")).doesNotContain("("));
  }

  @Test
  void goesToLabelsThatAreThere() throws IOException {
    List<String> wanted =
        Pattern.compile("goto (\\w+)").matcher(text()).results().map(r -> r.group(1)).toList();

    assertThat(wanted).contains("start", "nojava");
    assertThat(lines()).containsAll(wanted.stream().map(label -> ":" + label).toList());
  }

  /** With single line feeds cmd.exe misses labels. */
  @Test
  void hasTheLineEndsOfWindows() throws IOException {
    assertThat(Pattern.compile("(?<!\r)\n").matcher(text()).results().map(MatchResult::start))
        .isEmpty();
  }

  /** Without a "where" or a Java before it, the error level is that of whoever calls. */
  @Test
  void asksForTheErrorLevelOfItsOwnPrograms() throws IOException {
    List<String> lines = lines().stream().filter(line -> !line.startsWith("rem ")).toList();
    for (int i = 1; i < lines.size(); i++) {
      if (lines.get(i).startsWith("if errorlevel")
          || lines.get(i).startsWith("if not errorlevel")) {
        assertThat(lines.get(i - 1)).doesNotStartWith("if ").doesNotStartWith("set ");
      }
    }
  }
}
