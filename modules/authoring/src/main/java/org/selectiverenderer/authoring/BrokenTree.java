package org.selectiverenderer.authoring;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.x3d.source.DocumentError;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * The element tree of a text from before it stopped being well-formed, and the range that has
 * changed since: when that is well-formed again, only it has to be parsed.
 */
final class BrokenTree {
  /** Most characters of a range that is tried alone. */
  private static final int MOST = 1_000_000;

  private final ElementTree tree;

  /** The range in the tree's text; of no length before the first change. */
  private int from = Integer.MAX_VALUE;

  private int to;

  /** The end of the range in the present text. */
  private int end;

  /** Whether the tree was asked about the present text, so that its fault is that of it. */
  private boolean told;

  BrokenTree(ElementTree tree) {
    this.tree = tree;
  }

  /** Returns the fault of the present text; empty if nobody looked for it in this text. */
  Optional<DocumentError> fault() {
    return told ? tree.fault() : Optional.empty();
  }

  /** Returns the tree, which is that of the earlier text until it is mended. */
  ElementTree tree() {
    return tree;
  }

  /**
   * Follows further changes.
   *
   * @param attempt whether the text may be well-formed now
   * @param text the text after the changes
   * @return whether the tree is that of the text again
   */
  boolean mended(List<TextEdit> changes, boolean attempt, CharSequence text, long revision) {
    add(changes);
    boolean near = end - from <= MOST;
    told = !attempt || near;
    boolean mends =
        attempt
            && near
            && tree.follow(
                List.of(new TextEdit(from, to, text.subSequence(from, end).toString())), revision);
    if (mends) {
      tree.attach();
    }
    return mends;
  }

  private void add(List<TextEdit> changes) {
    int first = changes.get(0).from();
    int last = changes.get(changes.size() - 1).to();
    if (from == Integer.MAX_VALUE) {
      to = last;
      end = last;
    } else if (last > end) {
      to += last - end;
      end = last;
    }
    from = Math.min(from, first);
    end += changes.stream().mapToInt(TextEdit::growth).sum();
  }
}
