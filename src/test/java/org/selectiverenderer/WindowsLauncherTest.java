package org.selectiverenderer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
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
        .allSatisfy(
            line ->
                assertThat(QUOTED.matcher(line.replace(" in (java.exe) do ", "")).replaceAll(""))
                    .doesNotContain("("));
  }

  @Test
  void goesToLabelsThatAreThere() throws IOException {
    List<String> wanted =
        Pattern.compile("(?:goto |call :)(\\w+)")
            .matcher(text())
            .results()
            .map(result -> result.group(1))
            .toList();

    assertThat(wanted).contains("start", "nojava", "isjava");
    assertThat(lines())
        .filteredOn(line -> line.startsWith(":"))
        .doesNotHaveDuplicates()
        .containsExactlyInAnyOrderElementsOf(
            wanted.stream().distinct().map(label -> ":" + label).toList());
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

  private static String script() throws IOException {
    return Files.readString(Path.of("selective-renderer"));
  }

  private static Set<String> found(String pattern, String text) {
    return Pattern.compile(pattern)
        .matcher(text)
        .results()
        .map(MatchResult::group)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** All but those for its archive and its picture at the start, and macOS's for the Dock. */
  @Test
  void givesJavaTheFlagsOfTheOtherLauncher() throws IOException {
    String flag =
        "(?<=[ =\"])-(?:X\\w*[:\\w+-]*|D(?:joml|selective)[.\\w-]+|-(?:enable|sun)-[\\w-]+)(?:=[\\w-]+)?";
    Set<String> flags = found(flag, script().replace(',', ' '));
    flags.removeIf(
        each ->
            each.matches(".*(ClassList|Archive|ErrorFile|Xshare|XshowSettings|Xdock|splash).*"));
    Set<String> own = found(flag, text());

    assertThat(flags).contains("-Djoml.nounsafe=true", "-Xmx1200m", "-XX:+UseSerialGC");
    assertThat(own).isEqualTo(flags);
  }

  @Test
  void readsTheVariablesOfTheOtherLauncher() throws IOException {
    String variable = "(?:SELECTIVE_RENDERER|JAVA)_(?!VERSION|RUNTIME)[A-Z_]+";
    Set<String> variables = found(variable, script());
    variables.remove("SELECTIVE_RENDERER_CLASSES"); // For the archive of classes.
    variables.remove("SELECTIVE_RENDERER_DESKTOP"); // For the picture at the start.
    assertThat(found(variable, text())).isEqualTo(variables).hasSize(3);
  }

  @Test
  void startsTheSameCommandsLightly() throws IOException {
    String light = found("run [\\w |]+\\) flags=.*light", script()).iterator().next();
    Set<String> commands = found("\\w+(?= [|]|\\) )", light);
    assertThat(commands).contains("run", "doctor");
    assertThat(found("(?<=\"%~1\"==\")\\w+(?=\" set \"SR_FLAGS=%SR_FLAGS% %SR_LIGHT%)", text()))
        .isEqualTo(commands);
  }

  /** In a package, after a download, and where it builds. */
  @Test
  void knowsTheFilesOfTheOtherLauncher() throws IOException {
    String windows = text().replace('\\', '/');
    for (String file :
        List.of(
            "runtime/bin/java", "target/downloaded", "target/x3d-sai.jar", "/launcher-build.log")) {
      assertThat(script()).contains(file);
      assertThat(windows).contains(file);
    }
    assertThat(script())
        .contains("find pom.xml src/pom.xml src/main modules/*/pom.xml", "store=$home/app");
    assertThat(windows)
        .contains(
            "$roots = 'pom.xml', 'src/pom.xml', 'src/main', 'modules/*/pom.xml'",
            "SR_STORE=%SR_HOME%app");
  }

  @Test
  void saysWhatTheOtherLauncherSays() throws IOException {
    Set<String> sentences = found("(?<=fail \")[^\"$]{30,}(?=\")", script());
    assertThat(sentences).hasSizeGreaterThan(2);
    assertThat(text()).contains(sentences);
    assertThat(text().chars()).allMatch(letter -> letter < 128);
  }
}
