package org.selectiverenderer.polygon.versions;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.x3d.SceneElement;
import org.selectiverenderer.x3d.SceneText;

/** Changes to a scene's text in the hand of its author: indentation, ends of lines, quotes. */
final class TextEdits {
  private record Replacement(int from, int to, String text) {}

  private final SceneText scene;
  private final String text;
  private final List<Replacement> replacements = new ArrayList<>();

  TextEdits(SceneText scene) {
    this.scene = scene;
    this.text = scene.characters();
  }

  /** Puts lines in an element's place; the first takes its indentation, the others are told. */
  void replace(SceneElement element, List<String> lines) {
    String separator = endOfLine() + indentation(element);
    add(element.start(), element.end(), String.join(separator, lines));
  }

  /** Takes an element out, with the line that it stands on if nothing else does. */
  void remove(SceneElement element) {
    int from = lineStart(element.start());
    boolean alone = text.substring(from, element.start()).isBlank();
    int to = element.end();
    int after = to;
    while (after < text.length() && (text.charAt(after) == ' ' || text.charAt(after) == '\t')) {
      after++;
    }
    boolean last =
        after == text.length() || text.charAt(after) == '\r' || text.charAt(after) == '\n';
    if (alone && last) {
      // The end of the line before goes, so that the end of the last line stays.
      int cut = from;
      if (cut > 0 && text.charAt(cut - 1) == '\n') {
        cut--;
      }
      if (cut > 0 && text.charAt(cut - 1) == '\r') {
        cut--;
      }
      add(cut, after, "");
    } else {
      add(element.start(), to, "");
    }
  }

  /** Puts an element's text behind another, on a line of its own if that one stands on one. */
  void insertAfter(SceneElement element, List<String> elements) {
    boolean alone = text.substring(lineStart(element.start()), element.start()).isBlank();
    String separator = alone ? endOfLine() + indentation(element) : "";
    StringBuilder added = new StringBuilder();
    elements.forEach(other -> added.append(separator).append(other));
    add(element.end(), element.end(), added.toString());
  }

  private void add(int from, int to, String replacement) {
    replacements.add(new Replacement(from, to, replacement));
    replacements.sort(Comparator.comparingInt(Replacement::from));
  }

  String source(SceneElement element) {
    return text.substring(element.start(), element.end());
  }

  /** One step of indentation. */
  String step(SceneElement element) {
    return indentation(element).contains("\t") ? "\t" : "  ";
  }

  /** The quote that the author prefers. */
  char quote() {
    int single = text.indexOf("='");
    int twice = text.indexOf("=\"", Math.max(0, text.indexOf("?>")));
    return single < 0 || twice >= 0 && twice < single ? '"' : '\'';
  }

  private String indentation(SceneElement element) {
    int from = lineStart(element.start());
    int to = from;
    while (to < element.start() && (text.charAt(to) == ' ' || text.charAt(to) == '\t')) {
      to++;
    }
    return text.substring(from, to);
  }

  private int lineStart(int offset) {
    int at = offset;
    while (at > 0 && text.charAt(at - 1) != '\n' && text.charAt(at - 1) != '\r') {
      at--;
    }
    return at;
  }

  private String endOfLine() {
    int feed = text.indexOf('\n');
    if (feed < 0) {
      return text.indexOf('\r') < 0 ? "\n" : "\r";
    }
    return feed > 0 && text.charAt(feed - 1) == '\r' ? "\r\n" : "\n";
  }

  /** The text with all changes. */
  String changed() {
    StringBuilder changed = new StringBuilder();
    int at = 0;
    for (Replacement replacement : replacements) {
      changed.append(text, at, replacement.from()).append(replacement.text());
      at = replacement.to();
    }
    return changed.append(text, at, text.length()).toString();
  }

  List<VersionPlan.Edit> edits(String file) {
    return replacements.stream()
        .map(
            replacement -> {
              String before = text.substring(replacement.from(), replacement.to());
              String start = text.substring(lineStart(replacement.from()), replacement.from());
              String indent = before.isBlank() || !start.isBlank() ? "" : start;
              return new VersionPlan.Edit(
                  scene.location(file, replacement.from()).line(),
                  indent + before,
                  indent + replacement.text(),
                  replacement.from(),
                  replacement.to(),
                  replacement.text());
            })
        .toList();
  }
}
