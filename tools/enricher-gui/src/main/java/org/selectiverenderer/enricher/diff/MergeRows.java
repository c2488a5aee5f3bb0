package org.selectiverenderer.enricher.diff;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.file.ThreeWayMerge;
import org.selectiverenderer.authoring.file.ThreeWayMerge.Choice;
import org.selectiverenderer.authoring.file.ThreeWayMerge.Kind;

/** The rows of two texts side by side, and the decisions about their conflicts. */
final class MergeRows {
  private static final int CONTEXT = 3;

  /**
   * A row with a line of each text.
   *
   * @param part the index of its part; -1 for a gap of unchanged lines
   * @param conflict the number of its conflict from 0; -1 for none
   */
  record Row(int part, int conflict, Kind kind, String mine, String theirs) {}

  private final ThreeWayMerge merge;
  private final List<Row> rows = new ArrayList<>();
  private final List<Optional<Choice>> choices = new ArrayList<>();

  MergeRows(ThreeWayMerge merge) {
    this.merge = merge;
    List<ThreeWayMerge.Part> parts = merge.parts();
    for (int i = 0; i < parts.size(); i++) {
      ThreeWayMerge.Part part = parts.get(i);
      if (part.kind() == Kind.SAME) {
        same(i, lines(part.mine()), i == 0, i == parts.size() - 1);
      } else {
        boolean open = part.kind() == Kind.CONFLICT;
        add(i, part, open ? choices.size() : -1);
        if (open) {
          choices.add(Optional.empty());
        }
      }
    }
  }

  /** Splits a text into lines as they are shown: with spaces for tabs. */
  private static List<String> lines(String text) {
    return text.lines().map(line -> line.replace("\t", "  ")).toList();
  }

  private void same(int part, List<String> lines, boolean first, boolean last) {
    int before = first ? 0 : Math.min(CONTEXT, lines.size());
    int behind = last ? 0 : Math.min(CONTEXT, lines.size() - before);
    lines.subList(0, before).forEach(line -> same(part, line));
    int left = lines.size() - before - behind;
    if (left > 0) {
      rows.add(new Row(-1, -1, Kind.SAME, "\u2026", "\u2026"));
    }
    lines.subList(lines.size() - behind, lines.size()).forEach(line -> same(part, line));
  }

  private void same(int part, String line) {
    rows.add(new Row(part, -1, Kind.SAME, line, line));
  }

  private void add(int index, ThreeWayMerge.Part part, int conflict) {
    List<String> mine = lines(part.mine());
    List<String> theirs = lines(part.theirs());
    for (int i = 0; i < Math.max(mine.size(), theirs.size()); i++) {
      rows.add(
          new Row(
              index,
              conflict,
              part.kind(),
              i < mine.size() ? mine.get(i) : "",
              i < theirs.size() ? theirs.get(i) : ""));
    }
  }

  List<Row> rows() {
    return rows;
  }

  int conflicts() {
    return choices.size();
  }

  int undecided() {
    return (int) choices.stream().filter(Optional::isEmpty).count();
  }

  Optional<Choice> choice(int conflict) {
    return choices.get(conflict);
  }

  void decide(int conflict, Choice choice) {
    choices.set(conflict, Optional.of(choice));
  }

  /** Whether a side of a row is in the result; empty while undecided. */
  Optional<Boolean> taken(Row row, boolean mine) {
    return switch (row.kind()) {
      case SAME -> Optional.of(true);
      case MINE -> Optional.of(mine);
      case THEIRS -> Optional.of(!mine);
      case CONFLICT ->
          choices.get(row.conflict()).map(choice -> choice != (mine ? Choice.THEIRS : Choice.MINE));
    };
  }

  /** The first row of the next conflict after a row, or else of the first conflict; -1 for none. */
  int next(int row) {
    int first = -1;
    for (int i = 0; i < rows.size(); i++) {
      boolean begins =
          rows.get(i).conflict() >= 0
              && (i == 0 || rows.get(i - 1).conflict() != rows.get(i).conflict());
      if (begins && i > row) {
        return i;
      }
      first = begins && first < 0 ? i : first;
    }
    return first;
  }

  /** The decisions, once all are made. */
  List<Choice> choices() {
    return choices.stream().map(Optional::orElseThrow).toList();
  }

  /** The merged text, once all conflicts are decided. */
  String text() {
    return merge.text(choices());
  }
}
