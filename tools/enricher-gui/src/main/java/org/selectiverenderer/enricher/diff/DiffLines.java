package org.selectiverenderer.enricher.diff;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The lines of a unified diff, and where its changes begin.
 *
 * @param changes indices of the first line of each run of added and removed lines, in order
 */
record DiffLines(List<Line> lines, List<Integer> changes) {
  /** Most lines of a run that are looked through for a partner, as a run can be a whole file. */
  private static final int RUN = 1000;

  /** The kind of a line of a diff. */
  enum Kind {
    FILE("diff.line.file"),
    PLACE("diff.line.place"),
    SAME("diff.line.unchanged"),
    ADDED("diff.line.added"),
    REMOVED("diff.line.removed");

    private final String key;

    Kind(String key) {
      this.key = key;
    }

    /** The kind as a screen reader says it. */
    String word() {
      return Texts.of(key);
    }
  }

  /**
   * @param text with the leading sign, without the line end
   */
  record Line(Kind kind, String text) {}

  DiffLines {
    lines = List.copyOf(lines);
    changes = List.copyOf(changes);
  }

  /** Parses the output of {@code UnifiedDiff}. */
  static DiffLines of(String diff) {
    List<Line> lines = new ArrayList<>();
    List<Integer> changes = new ArrayList<>();
    boolean heads = true;
    boolean within = false;
    for (int from = 0; from < diff.length(); ) {
      int end = diff.indexOf('\n', from);
      end = end < 0 ? diff.length() : end;
      String text = diff.substring(from, end);
      from = end + 1;
      heads = heads && lines.size() < 2;
      Kind kind = heads ? Kind.FILE : kind(text);
      boolean change = kind == Kind.ADDED || kind == Kind.REMOVED;
      if (change && !within) {
        changes.add(lines.size());
      }
      within = change;
      lines.add(new Line(kind, text.endsWith("\r") ? text.substring(0, text.length() - 1) : text));
    }
    return new DiffLines(lines, changes);
  }

  private static Kind kind(String text) {
    return switch (text.isEmpty() ? ' ' : text.charAt(0)) {
      case '+' -> Kind.ADDED;
      case '-' -> Kind.REMOVED;
      case '@' -> Kind.PLACE;
      default -> Kind.SAME;
    };
  }

  long added() {
    return lines.stream().filter(line -> line.kind() == Kind.ADDED).count();
  }

  long removed() {
    return lines.stream().filter(line -> line.kind() == Kind.REMOVED).count();
  }

  /**
   * Returns the line of the same number in the run of added lines behind a removed one, or of
   * removed lines before an added one; empty without one.
   */
  String beside(int line) {
    Kind kind = lines.get(line).kind();
    if (kind != Kind.REMOVED && kind != Kind.ADDED) {
      return "";
    }
    int begin = begin(line, kind);
    int number = line - begin;
    Kind partner = kind == Kind.ADDED ? Kind.REMOVED : Kind.ADDED;
    int first;
    if (kind == Kind.ADDED) {
      first = begin(begin, partner);
    } else {
      first = line;
      while (is(first, kind) && first - line < RUN) {
        first++;
      }
    }
    int at = first + number;
    return is(at, partner) ? lines.get(at).text() : "";
  }

  /** Returns the first line of the run of a kind that ends before a line. */
  private int begin(int line, Kind kind) {
    int begin = line;
    while (is(begin - 1, kind) && line - begin < RUN) {
      begin--;
    }
    return begin;
  }

  private boolean is(int line, Kind kind) {
    return line >= 0 && line < lines.size() && lines.get(line).kind() == kind;
  }

  /** The first change after a line; after the last change the first of all. */
  int next(int line) {
    return changes.stream().filter(at -> at > line).findFirst().orElse(first());
  }

  /** The last change before a line; the last of all before the first. */
  int previous(int line) {
    int found = changes.isEmpty() ? -1 : changes.get(changes.size() - 1);
    for (int i = changes.size() - 1; i >= 0; i--) {
      if (changes.get(i) < line) {
        return changes.get(i);
      }
    }
    return found;
  }

  private int first() {
    return changes.isEmpty() ? -1 : changes.get(0);
  }
}
