package org.selectiverenderer.authoring.editing;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Comments out a part of a scene's text, and uncomments it. Nested comments become {@code <!~~
 * ~~>}, since comments do not nest (XML 1.0, 2.5).
 */
public final class CommentToggle {
  private static final String OPEN = "<!--";
  private static final String CLOSE = "-->";

  private CommentToggle() {}

  /**
   * Comments out a range, or uncomments the comment that contains it.
   *
   * @param from offset of the first character; white space at both ends stays outside the comment
   * @param to offset after the last one
   * @param name name of the undo step
   * @throws EditRejectedException if there is nothing to comment out, or the range contains two
   *     hyphens, which are not allowed in a comment
   */
  public static Edit toggle(CharSequence text, int from, int to, String name) {
    int start = from;
    int end = to;
    while (start < end && text.charAt(start) <= ' ') {
      start++;
    }
    while (end > start && text.charAt(end - 1) <= ' ') {
      end--;
    }
    int open = openBefore(text, start);
    if (open >= 0) {
      return opened(text, open, name);
    }
    if (start == end) {
      throw new EditRejectedException("There is nothing to comment out on this line");
    }
    return new Edit(name, closed(text, start, end));
  }

  /** Returns the start of the comment that contains an offset; -1 for none. */
  static int openBefore(CharSequence text, int at) {
    for (int i = Math.min(at, text.length() - OPEN.length()); i >= 0; i--) {
      if (stands(text, i, OPEN)) {
        return i;
      }
      if (i + CLOSE.length() <= at && stands(text, i, CLOSE)) {
        return -1;
      }
    }
    return -1;
  }

  private static boolean stands(CharSequence text, int at, String word) {
    for (int i = 0; i < word.length(); i++) {
      if (at + i >= text.length() || text.charAt(at + i) != word.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  private static Edit opened(CharSequence text, int open, String name) {
    int close = open + OPEN.length();
    while (close < text.length() && !stands(text, close, CLOSE)) {
      close++;
    }
    if (close == text.length()) {
      throw new EditRejectedException("The comment is not closed; add --> at its end");
    }
    int from = open + OPEN.length();
    int to = close;
    from += from < to && text.charAt(from) == ' ' ? 1 : 0;
    to -= to > from && text.charAt(to - 1) == ' ' ? 1 : 0;
    List<TextEdit> changes = new ArrayList<>();
    changes.add(TextEdit.remove(open, from));
    for (int i = from; i < to; i++) {
      if (stands(text, i, "<!~~")) {
        changes.add(new TextEdit(i, i + 4, OPEN));
      } else if (stands(text, i, "~~>")) {
        changes.add(new TextEdit(i, i + 3, CLOSE));
      }
    }
    changes.add(TextEdit.remove(to, close + CLOSE.length()));
    return new Edit(name, changes);
  }

  private static List<TextEdit> closed(CharSequence text, int start, int end) {
    List<TextEdit> changes = new ArrayList<>();
    changes.add(TextEdit.insert(start, OPEN + " "));
    for (int i = start; i < end; i++) {
      if (stands(text, i, OPEN)) {
        changes.add(new TextEdit(i, i + 4, "<!~~"));
        i += 3;
      } else if (stands(text, i, CLOSE)) {
        changes.add(new TextEdit(i, i + 3, "~~>"));
        i += 2;
      } else if (stands(text, i, "--")) {
        throw new EditRejectedException(
            "A comment must not contain two hyphens in a row (--); change them first");
      }
    }
    changes.add(TextEdit.insert(end, " " + CLOSE));
    return changes;
  }
}
