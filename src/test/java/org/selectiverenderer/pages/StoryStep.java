package org.selectiverenderer.pages;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Pattern;

/**
 * What a reader of a story types, and what it says that comes of it.
 *
 * @param words of the command, the program's name first; of a change to a file {@link #REPLACE},
 *     what is replaced, by what, and the file
 * @param prints pieces of what is printed, in their order; {@code ...} in the page stands between
 *     them
 * @param shown what the page shows as printed, as it is written there
 */
record StoryStep(List<String> words, List<String> prints, String shown) {
  static final String REPLACE = "replace";
  private static final String PROGRAM = "./selective-renderer";
  private static final Pattern CHANGE =
      Pattern.compile("replace\\s+`([^`]+)`\\s+by\\s+`([^`]+)`\\s+in\\s+`([^`]+)`");
  private static final Pattern WORD = Pattern.compile("'([^']*)'|\"([^\"]*)\"|(\\S+)");

  /**
   * The commands of a page: lines of blocks that begin with the program's name, or after {@code $}
   * with what is printed below them. A backslash at the end goes on in the next line. Between them
   * changes to files by a text editor: "replace `this` by `that` in `file`".
   */
  static List<StoryStep> of(MarkdownPage page) {
    SortedMap<Integer, List<StoryStep>> byPlace = new TreeMap<>();
    CHANGE
        .matcher(page.text())
        .results()
        .forEach(
            change -> {
              List<String> words =
                  List.of(REPLACE, change.group(1), change.group(2), change.group(3));
              byPlace.put(change.start(), List.of(new StoryStep(words, List.of(), "")));
            });
    page.blocks().forEach(block -> byPlace.put(block.start(), commands(block)));
    return byPlace.values().stream().flatMap(List::stream).toList();
  }

  private static List<StoryStep> commands(MarkdownPage.Block block) {
    List<StoryStep> steps = new ArrayList<>();
    String text = block.text().replaceAll("\\\\\\n\\s*", "");
    if (text.startsWith("$ ")) {
      for (String shown : text.split("(?m)^\\$ ")) {
        shown(shown).ifPresent(steps::add);
      }
    } else if (text.startsWith(PROGRAM)) {
      text.lines().forEach(line -> steps.add(new StoryStep(words(line), List.of(), "")));
    }
    return steps;
  }

  private static Optional<StoryStep> shown(String text) {
    if (text.isBlank()) {
      return Optional.empty();
    }
    int end = text.indexOf('\n');
    String shown = text.substring(end + 1);
    List<String> prints =
        List.of(shown.split("(?m)^\\.\\.\\.$")).stream()
            .map(String::strip)
            .filter(piece -> !piece.isEmpty())
            .toList();
    return Optional.of(new StoryStep(words(text.substring(0, end)), prints, shown.strip()));
  }

  private static List<String> words(String line) {
    return WORD.matcher(line)
        .results()
        .map(
            word ->
                word.group(1) != null
                    ? word.group(1)
                    : word.group(2) != null ? word.group(2) : word.group(3))
        .toList();
  }

  /** Whether it asks for the exit status of the command before. */
  boolean asksForStatus() {
    return words.equals(List.of("echo", "$?"));
  }

  /** Whether it is a command of the program. */
  boolean isOurs() {
    return words.get(0).equals(PROGRAM);
  }

  /** Whether it opens a window that stays until somebody closes it. */
  boolean waitsForSomebody() {
    return is("run") && !words.contains("--offscreen") || is("enrich") && words.size() == 3;
  }

  /** Whether it plays a device for the commands after it, until it is ended. */
  boolean staysBeside() {
    return words.contains("--emulate");
  }

  /**
   * Whether it draws the apartment, makes a session or analyses one, or needs what such a command
   * has made. The tests of these commands do the same.
   */
  boolean takesLong() {
    return words.contains("analyse")
        || words.contains("--power")
        || words.contains("scenes/apartment.x3d") && !words.contains("new")
        || words.stream().anyMatch(word -> word.startsWith("my-study")) && !words.contains("new");
  }

  boolean is(String command) {
    return words.size() > 1 && words.get(1).equals(command);
  }
}
