package org.selectiverenderer.authoring.file;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * The three-way merge of two texts line by line, as by diff3: changes of one side are taken,
 * different changes of both sides are conflicts that the user resolves. Without the common ancestor
 * all differences are conflicts. Immutable.
 */
public final class ThreeWayMerge {
  /** The kind of a part of the texts. */
  public enum Kind {
    SAME,
    /** Changed only in the own text, or in both texts alike. */
    MINE,
    /** Changed only in the other text. */
    THEIRS,
    CONFLICT
  }

  /** The resolution of a conflict. */
  public enum Choice {
    MINE,
    THEIRS,
    MINE_FIRST,
    THEIRS_FIRST
  }

  /**
   * A part of both texts: lines with their line ends.
   *
   * @param from offset of the part in the own text
   */
  public record Part(Kind kind, int from, String mine, String theirs) {
    String result(Choice choice) {
      return switch (kind) {
        case SAME, MINE -> mine;
        case THEIRS -> theirs;
        case CONFLICT ->
            switch (choice) {
              case MINE -> mine;
              case THEIRS -> theirs;
              case MINE_FIRST -> ended(mine, theirs) + theirs;
              case THEIRS_FIRST -> ended(theirs, mine) + mine;
            };
      };
    }

    /** Adds a line end to the last line of a text, if more text follows. */
    private static String ended(String first, String then) {
      boolean open = !first.isEmpty() && !then.isEmpty() && !first.endsWith("\n");
      return open ? first + (then.endsWith("\r\n") ? "\r\n" : "\n") : first;
    }
  }

  private final List<Part> parts;

  private ThreeWayMerge(List<Part> parts) {
    this.parts = List.copyOf(parts);
  }

  /**
   * Merges two texts.
   *
   * @param base the common ancestor, if it is known
   * @param theirs the other text; its line ends are converted to those of {@code mine}
   */
  public static ThreeWayMerge of(Optional<String> base, String mine, String theirs) {
    List<String> here = LineTokenizer.of(mine);
    List<String> there = LineTokenizer.of(ends(theirs, mine.contains("\r\n")));
    List<String> from = base.map(LineTokenizer::of).orElseGet(() -> common(here, there));
    return new ThreeWayMerge(parts(from, here, there, base.isPresent()));
  }

  private static String ends(String text, boolean windows) {
    String plain = text.replace("\r\n", "\n");
    return windows ? plain.replace("\n", "\r\n") : plain;
  }

  private static List<String> common(List<String> here, List<String> there) {
    int[] partner = PatienceDiff.of(here, there);
    List<String> common = new ArrayList<>();
    for (int i = 0; i < partner.length; i++) {
      if (partner[i] >= 0) {
        common.add(here.get(i));
      }
    }
    return common;
  }

  private static List<Part> parts(
      List<String> from, List<String> here, List<String> there, boolean known) {
    int[] toHere = PatienceDiff.of(from, here);
    int[] toThere = PatienceDiff.of(from, there);
    List<Part> parts = new ArrayList<>();
    int b = 0;
    int m = 0;
    int t = 0;
    int offset = 0;
    while (b < from.size() || m < here.size() || t < there.size()) {
      int end = b;
      while (end < from.size() && (toHere[end] < 0 || toThere[end] < 0)) {
        end++;
      }
      int mineEnd = end < from.size() ? toHere[end] : here.size();
      int theirsEnd = end < from.size() ? toThere[end] : there.size();
      String mine = String.join("", here.subList(m, mineEnd));
      String theirs = String.join("", there.subList(t, theirsEnd));
      if (!mine.isEmpty() || !theirs.isEmpty()) {
        String before = String.join("", from.subList(b, end));
        parts.add(new Part(kind(known, before, mine, theirs), offset, mine, theirs));
        offset += mine.length();
      }
      b = end;
      m = mineEnd;
      t = theirsEnd;
      StringBuilder same = new StringBuilder();
      while (b < from.size() && toHere[b] == m && toThere[b] == t) {
        same.append(here.get(m));
        b++;
        m++;
        t++;
      }
      if (same.length() > 0) {
        parts.add(new Part(Kind.SAME, offset, same.toString(), same.toString()));
        offset += same.length();
      }
    }
    return parts;
  }

  private static Kind kind(boolean known, String before, String mine, String theirs) {
    if (mine.equals(theirs)) {
      return Kind.MINE;
    }
    if (known && mine.equals(before)) {
      return Kind.THEIRS;
    }
    return known && theirs.equals(before) ? Kind.MINE : Kind.CONFLICT;
  }

  /** Returns all parts in order. */
  public List<Part> parts() {
    return parts;
  }

  /** Returns the number of parts of a kind. */
  public int count(Kind kind) {
    return (int) parts.stream().filter(part -> part.kind() == kind).count();
  }

  /** Returns the merged text with the conflicts resolved in order. */
  public String text(List<Choice> choices) {
    StringBuilder text = new StringBuilder();
    int conflict = 0;
    for (Part part : parts) {
      boolean open = part.kind() == Kind.CONFLICT;
      text.append(part.result(open ? choices.get(conflict++) : Choice.MINE));
    }
    return text.toString();
  }

  /** Returns the merge as an edit of the own text, which leaves unchanged parts untouched. */
  public Edit edit(String name, List<Choice> choices) {
    List<TextEdit> changes = new ArrayList<>();
    int conflict = 0;
    for (Part part : parts) {
      boolean open = part.kind() == Kind.CONFLICT;
      String result = part.result(open ? choices.get(conflict++) : Choice.MINE);
      if (!result.equals(part.mine())) {
        changes.add(new TextEdit(part.from(), part.from() + part.mine().length(), result));
      }
    }
    return new Edit(name, changes);
  }
}
