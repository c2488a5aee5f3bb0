package org.selectiverenderer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Every picture of the pages can be taken anew: docs/pictures.sh names it, and nothing else. */
class PicturesScriptTest {
  private static final Path SCRIPT = Path.of("docs/pictures.sh");
  private static final Path FOLDER = Path.of("docs/pictures");
  private static final Pattern ROW = Pattern.compile("(?m)^([\\w-]+\\.(?:png|jpg|svg)) +([a-z]+)$");
  private static final Pattern LINK = Pattern.compile("pictures/([\\w-]+\\.(?:png|jpg|svg))");

  private static Set<String> named(Pattern pattern, String text) {
    return pattern.matcher(text).results().map(hit -> hit.group(1)).collect(ordered());
  }

  private static java.util.stream.Collector<String, ?, Set<String>> ordered() {
    return Collectors.toCollection(TreeSet::new);
  }

  private static Set<String> inScript() throws IOException {
    return named(ROW, Files.readString(SCRIPT));
  }

  @Test
  void theScriptNamesThePicturesThatAreThere() throws IOException {
    try (Stream<Path> files = Files.list(FOLDER)) {
      Set<String> there = files.map(file -> file.getFileName().toString()).collect(ordered());
      assertThat(inScript()).isEqualTo(there).hasSizeGreaterThan(50);
    }
  }

  @Test
  void pagesShowThePicturesThatAreThereAndNoOthers() throws IOException {
    Set<String> shown = new TreeSet<>();
    for (Path page : pages()) {
      shown.addAll(named(LINK, Files.readString(page)));
    }
    assertThat(shown).isEqualTo(inScript());
  }

  @Test
  void everyWayOfTakingThemIsExplained() throws IOException {
    String script = Files.readString(SCRIPT);
    Matcher rows = ROW.matcher(script);
    while (rows.find()) {
      assertThat(script).contains("    " + rows.group(2) + ") echo ");
    }
  }

  /** The patterns of the function that takes them, but for the one that takes none. */
  @Test
  void everyPictureHasARecipe() throws IOException {
    String script = Files.readString(SCRIPT);
    int from = script.indexOf("\ntake() {");
    String take = script.substring(from, script.indexOf("\n}\n", from));
    List<PathMatcher> recipes =
        Pattern.compile("(?m)^    ([\\w.*-]+(?: \\| [\\w.*-]+)*)\\)")
            .matcher(take)
            .results()
            .flatMap(hit -> Stream.of(hit.group(1).split(" \\| ")))
            .filter(pattern -> !pattern.equals("*"))
            .map(pattern -> FileSystems.getDefault().getPathMatcher("glob:" + pattern))
            .toList();
    for (String name : inScript()) {
      assertThat(recipes).as(name).anyMatch(recipe -> recipe.matches(Path.of(name)));
    }
  }

  private static List<Path> pages() throws IOException {
    try (Stream<Path> docs = Files.list(Path.of("docs"))) {
      return Stream.concat(
              Stream.of(Path.of("README.md"), Path.of("scenes/README.md")),
              docs.filter(file -> file.toString().endsWith(".md")))
          .toList();
    }
  }
}
