package org.selectiverenderer.x3d.vrml1;

import java.util.ArrayDeque;
import java.util.Deque;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.vrml.VrmlScanner;

/** The comments of a text, which wait for the element that follows them. */
final class PendingComments implements VrmlScanner.Comments {
  private record Comment(String words, int at) {}

  private final Deque<Comment> comments = new ArrayDeque<>();

  @Override
  public void comment(String words, int at) {
    // a lookahead may pass a comment twice
    if (comments.isEmpty() || comments.getLast().at() < at) {
      comments.add(new Comment(words, at));
    }
  }

  /** Adds the comments before an offset to the document. */
  void before(int offset, ElementTreeBuilder document) {
    while (!comments.isEmpty() && comments.getFirst().at() < offset) {
      Comment comment = comments.removeFirst();
      document.comment(comment.words(), comment.at());
    }
  }
}
