package org.selectiverenderer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Holds what can be said of the launcher in the packages for Windows by reading it and its
 * settings.
 */
class PackagedWindowsLauncherTest {
  private static String script() throws IOException {
    return Files.readString(Path.of("selective-renderer"));
  }

  private static List<String> settings() throws IOException {
    return Files.readAllLines(Path.of("packaging/windows/launcher.cfg")).stream()
        .filter(line -> !line.startsWith("#"))
        .toList();
  }

  private static Set<String> found(String pattern, String text) {
    return Pattern.compile(pattern)
        .matcher(text)
        .results()
        .map(MatchResult::group)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Returns the flags that a command gets, or those of all commands. */
  private static Set<String> flags(String command) throws IOException {
    return settings().stream()
        .map(line -> line.split(" ", 2))
        .filter(line -> Arrays.asList(line[0].split(",")).contains(command))
        .flatMap(line -> Stream.of(line[1].split(" ")))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  @Test
  void givesJavaTheFlagsOfTheOtherLauncher() throws IOException {
    String flag = "(?<=[ ,=\"])-(?:X[X:+\\w]+|D(?:joml|selective)[.\\w-]+)(?:=(?!-)[\\w-]+)?";
    Set<String> wanted = found(flag, script());
    wanted.removeIf(
        each ->
            each.matches(
                ".*(ClassList|Archive|ErrorFile|Xshare|XshowSettings|Xmx4g|Xdock|splash).*"));
    wanted.add("-Dselective-renderer.arguments=unicode"); // Of this launcher alone.
    Set<String> own = found(flag, String.join("\n", settings()));
    assertThat(own).contains("-Dselective-renderer.installed=true").isEqualTo(wanted);
  }

  @Test
  void startsTheSameCommandsLightly() throws IOException {
    String light = found("run [\\w |]+\\) flags=.*light", script()).iterator().next();
    for (String command : found("\\w+(?= [|]|\\) )", light)) {
      assertThat(flags(command)).contains("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");
    }
    assertThat(flags("all")).doesNotContain("-XX:TieredStopAtLevel=1");
    assertThat(flags("bench"))
        .containsExactly(
            "-Dselective-renderer.run-flags=" + String.join(",", orderedFlags("simulate")));
  }

  private static List<String> orderedFlags(String command) throws IOException {
    return settings().stream()
        .filter(line -> line.split(" ")[0].contains(command))
        .flatMap(line -> Stream.of(line.split(" ")).skip(1))
        .toList();
  }

  @Test
  void readsTheVariablesOfTheOtherLauncherButJavasHome() throws IOException {
    String variable = "SELECTIVE_RENDERER_[A-Z_]+";
    Set<String> wanted = found(variable, script());
    wanted.remove("SELECTIVE_RENDERER_CLASSES"); // For packaging/package.
    wanted.remove("SELECTIVE_RENDERER_DESKTOP"); // Of desktop entries.
    assertThat(found(variable, Files.readString(Path.of("packaging/windows/launcher.c"))))
        .isEqualTo(wanted);
  }

  /** Java itself only knows the flag -splash in its own launcher. */
  @Test
  void showsThePictureForTheCommandsOfTheOtherLauncher() throws IOException {
    String source = Files.readString(Path.of("packaging/windows/launcher.c"));
    String own =
        source.substring(
            source.indexOf("static int opens_window("), source.indexOf("SharedArchive"));
    Set<String> opening = found("[\\w/*| -]+(?=\\) splash=yes ;;\n  run)", script());
    Set<String> plain = found("[\\w*| -]+(?=\\) splash= ;;)", script());
    assertThat(opening).hasSize(1);
    assertThat(plain).hasSize(1);
    Set<String> words = found("[\\w-]+", opening + " " + plain);
    assertThat(words).contains("start", "enrich", "--study", "--apply", "-h");
    assertThat(found("(?<=L\")[\\w-]+(?=\")", own)).containsAll(words);
    assertThat(source).contains("app\\\\splash.png", "L\"-Dselective-renderer.splash=%ls\"");
  }

  /** Their sums are checked before anything is unpacked. */
  @Test
  void everyPlatformHasAPinnedJava() throws IOException {
    List<String> rows = Files.readAllLines(Path.of("packaging/runtimes.tsv"));
    assertThat(rows.get(0)).isEqualTo("platform\tarchive\tsha256");
    assertThat(rows.stream().skip(1))
        .allMatch(
            row -> row.matches("\\w+-\\w+\tjdk4py-[\\d.]+-py3-none-[\\w]+\\.whl\t[0-9a-f]{64}"));
    Set<String> platforms =
        found(
            "\"(?:linux|windows|macos)-\\w+64\"",
            Files.readString(Path.of("packaging/SlimJar.java")));
    assertThat(rows.stream().skip(1).map(row -> '"' + row.split("\t")[0] + '"'))
        .containsExactlyElementsOf(platforms);
  }
}
