package org.selectiverenderer.authoring.geometry;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.authoring.editing.FindingSuppression;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/**
 * Lists the faces of a scene that are searched for repeated points: those of which the author has
 * not accepted them, up to a bound of text.
 */
final class WeldableFaces {
  /** Faces with more text than this are not searched, so that a large scene is checked soon. */
  private static final int MOST = 4_000_000;

  /** Faces beyond this much text in all are not searched. */
  static final long MOST_IN_ALL = 12_000_000;

  private final String text;
  private final ElementTree tree;
  private final long mostInAll;

  WeldableFaces(String text, ElementTree tree) {
    this(text, tree, MOST_IN_ALL);
  }

  /**
   * @param mostInAll the most characters of faces that are searched in a scene
   */
  WeldableFaces(String text, ElementTree tree, long mostInAll) {
    this.text = text;
    this.tree = tree;
    this.mostInAll = mostInAll;
  }

  /** Returns the faces in document order. */
  List<DocumentElement> list() {
    List<DocumentElement> faces = new ArrayList<>();
    FindingSuppression.Comments accepted = new FindingSuppression.Comments(text);
    long[] left = {mostInAll};
    tree.root()
        .visit(
            element -> {
              if (GeometryRepair.INDEXED.contains(element.name())
                  && element.end() - element.start() < MOST
                  && left[0] > 0
                  && !accepted.suppress(RepeatedPointsCheck.RULE, element)) {
                left[0] -= element.end() - element.start();
                if (left[0] >= 0) {
                  faces.add(element);
                }
              }
            });
    return faces;
  }
}
