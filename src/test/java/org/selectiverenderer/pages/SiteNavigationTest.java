package org.selectiverenderer.pages;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The navigation of the site leads to every page, once. */
class SiteNavigationTest {
  private static final Path SETTINGS = Path.of("packaging/site/mkdocs.yml");
  private static final Pattern ENTRY = Pattern.compile("(?m)^ +- (?:[^:\\n]+: )?(\\S+\\.md)$");

  @Test
  void everyPageHasOnePlace() throws IOException {
    String settings = Files.readString(SETTINGS);
    String navigation = settings.substring(settings.indexOf("\nnav:\n"));
    List<String> named = ENTRY.matcher(navigation).results().map(entry -> entry.group(1)).toList();
    List<String> pages =
        new ArrayList<>(
            List.of(
                "README.md",
                "scenes/README.md",
                "ARCHITECTURE.md",
                "CONTRIBUTING.md",
                "CHANGELOG.md"));
    try (Stream<Path> docs = Files.list(Path.of("docs"))) {
      docs.map(file -> "docs/" + file.getFileName())
          .filter(file -> file.endsWith(".md"))
          .forEach(pages::add);
    }
    assertThat(named)
        .as("pages in the navigation of %s", SETTINGS)
        .containsExactlyInAnyOrderElementsOf(pages);
  }
}
