package org.selectiverenderer.authoring.versions;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Composes edits that are made one after the other, each of the text that the last one left, into
 * changes of the first text. Not thread-safe.
 */
public final class ComposedEdit {
  private final String original;
  private List<Piece> pieces;

  /**
   * A part of the present text.
   *
   * @param from where it begins in the original; negative for an inserted text
   */
  private record Piece(int from, String text) {
    Piece part(int start, int end) {
      return new Piece(from < 0 ? from : from + start, text.substring(start, end));
    }
  }

  /** Makes the edit of a text that changes nothing yet. */
  public ComposedEdit(String original) {
    this.original = original;
    this.pieces = List.of(new Piece(0, original));
  }

  /** Returns the present text. */
  public String text() {
    StringBuilder text = new StringBuilder();
    pieces.forEach(piece -> text.append(piece.text()));
    return text.toString();
  }

  /**
   * Adds an edit of the present text.
   *
   * @param changes its changes in ascending order, which do not overlap
   */
  public void add(List<TextEdit> changes) {
    List<Piece> result = new ArrayList<>();
    int at = 0;
    for (TextEdit change : changes) {
      copy(at, change.from(), result);
      if (!change.text().isEmpty()) {
        result.add(new Piece(-1, change.text()));
      }
      at = change.to();
    }
    copy(at, Integer.MAX_VALUE, result);
    pieces = result;
  }

  private void copy(int from, int to, List<Piece> result) {
    int start = 0;
    for (Piece piece : pieces) {
      int length = piece.text().length();
      int first = Math.max(0, from - start);
      int last = Math.min(length, to - start);
      if (first < last) {
        result.add(piece.part(first, last));
      }
      start += length;
    }
  }

  /** Returns the changes of the original that give the present text. */
  public List<TextEdit> changes() {
    List<TextEdit> changes = new ArrayList<>();
    StringBuilder inserted = new StringBuilder();
    int at = 0;
    for (Piece piece : pieces) {
      if (piece.from() < 0) {
        inserted.append(piece.text());
        continue;
      }
      add(changes, at, piece.from(), inserted);
      at = piece.from() + piece.text().length();
    }
    add(changes, at, original.length(), inserted);
    return changes;
  }

  private static void add(List<TextEdit> changes, int from, int to, StringBuilder inserted) {
    if (from < to || !inserted.isEmpty()) {
      changes.add(new TextEdit(from, to, inserted.toString()));
      inserted.setLength(0);
    }
  }
}
