package org.selectiverenderer.pages;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A page in Markdown.
 *
 * @param file as seen from the repository's folder
 * @param text its lines, ended by line feeds
 */
record MarkdownPage(Path file, String text) {
  private static final Pattern FENCE = Pattern.compile("(?ms)^( *)```([^\\n]*)\\n(.*?)^\\1```$");
  private static final Pattern CODE = Pattern.compile("(?s)(`+)(?!`).+?(?<!`)\\1(?!`)");
  private static final Pattern LINK =
      Pattern.compile("\\]\\(([^)]*)\\)|(?m)^\\[[^\\]^]+\\]: *(\\S+)");
  private static final Pattern HEADING = Pattern.compile("(?m)^#{1,6} +(.+)$");

  /** A block of code: where it begins, the words behind its fence, and what is in it. */
  record Block(int start, String language, String text) {}

  static MarkdownPage read(Path file) throws IOException {
    return new MarkdownPage(file, Files.readString(file).replace("\r\n", "\n"));
  }

  /** All pages of the repository that people read. */
  static List<MarkdownPage> all() throws IOException {
    List<MarkdownPage> pages = new ArrayList<>();
    for (String folder : List.of("", "docs", "scenes", "src/test/scripts")) {
      try (Stream<Path> files = Files.list(Path.of(folder))) {
        for (Path file : files.filter(f -> f.toString().endsWith(".md")).sorted().toList()) {
          pages.add(read(file));
        }
      }
    }
    return pages;
  }

  /** Where its links and pictures lead, as written. */
  List<String> links() {
    String prose = CODE.matcher(FENCE.matcher(text).replaceAll("")).replaceAll("");
    return LINK.matcher(prose)
        .results()
        .map(link -> link.group(1) == null ? link.group(2) : link.group(1))
        .toList();
  }

  /** Its blocks of code between fences. */
  List<Block> blocks() {
    return FENCE
        .matcher(text)
        .results()
        .map(block -> new Block(block.start(), block.group(2).strip(), block.group(3)))
        .toList();
  }

  /** What a link to a section may name, as GitHub derives it from the headings. */
  Set<String> anchors() {
    Map<String, Integer> seen = new HashMap<>();
    Set<String> anchors = new TreeSet<>();
    Matcher headings = HEADING.matcher(FENCE.matcher(text).replaceAll(""));
    while (headings.find()) {
      String words = headings.group(1).replaceAll("\\[([^\\]]*)\\]\\([^)]*\\)", "$1").strip();
      String anchor =
          words
              .toLowerCase(Locale.ROOT)
              .replaceAll("[^\\p{L}\\p{N}\\p{M}_ -]", "")
              .replace(' ', '-');
      int before = seen.merge(anchor, 1, Integer::sum) - 1;
      anchors.add(before == 0 ? anchor : anchor + "-" + before);
    }
    return anchors;
  }
}
