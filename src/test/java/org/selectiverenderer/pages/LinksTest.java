package org.selectiverenderer.pages;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** Links of pages lead to files and sections that are there. Other servers are not asked. */
class LinksTest {
  private static final String ELSEWHERE = "(?s)[a-z][a-z0-9+.-]*:.*";

  private final Map<Path, MarkdownPage> pages = new TreeMap<>();

  LinksTest() throws IOException {
    for (MarkdownPage page : MarkdownPage.all()) {
      pages.put(page.file(), page);
    }
  }

  @Test
  void linksLeadToWhatIsThere() throws IOException {
    assertThat(pages).hasSizeGreaterThan(30).containsKey(Path.of("docs/rules.md"));
    for (MarkdownPage page : pages.values()) {
      for (String link : page.links()) {
        if (!link.matches(ELSEWHERE)) {
          assertThat(fault(page, link)).as("%s: (%s)", page.file(), link).isEmpty();
        }
      }
    }
  }

  /** What is wrong with a link; empty if nothing is. */
  private String fault(MarkdownPage page, String link) throws IOException {
    if (link.isEmpty() || link.contains(" ") || link.contains("\n")) {
      return "a target is one word";
    }
    int mark = link.indexOf('#');
    String path = mark < 0 ? link : link.substring(0, mark);
    Path target = path.isEmpty() ? page.file() : page.file().resolveSibling(path);
    if (!Files.exists(target)) {
      return "no such file";
    }
    if (mark >= 0) {
      MarkdownPage other = pages.get(target.normalize());
      if (other == null || !other.anchors().contains(link.substring(mark + 1))) {
        return "no such section";
      }
    }
    return "";
  }

  @Test
  void faultsAreFound() throws IOException {
    MarkdownPage page =
        new MarkdownPage(
            Path.of("docs/a.md"),
            "[a](gone.md), [b](rules.md#sr999), [c](greek-\nterms.md), `[d](code)`, [e](#here)\n"
                + "## `Here`\n");
    List<String> faults =
        page.links().stream()
            .filter(link -> !link.startsWith("#"))
            .map(l -> found(page, l))
            .toList();
    assertThat(faults).containsExactly("no such file", "no such section", "a target is one word");
    assertThat(page.anchors()).containsExactly("here");
  }

  private String found(MarkdownPage page, String link) {
    try {
      return fault(page, link);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }
}
