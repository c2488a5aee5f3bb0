package org.selectiverenderer.authoring.editing;

import java.util.Optional;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/** Finds matching start tags and end tags in well-formed text. */
public final class TagMatcher {
  private TagMatcher() {}

  /**
   * Returns the start of an element's end tag; for an empty-element tag the start of the element.
   *
   * @param text the document's text
   */
  public static int endTag(CharSequence text, DocumentElement element) {
    if (!element.open()) {
      return element.start();
    }
    int at = element.end() - 1;
    while (text.charAt(at) != '<') {
      at--;
    }
    return at;
  }

  /**
   * Returns the start of the tag that matches the position at an offset: the end tag from anywhere
   * in an element, the start tag from the end tag. Empty outside the root and for empty-element
   * tags.
   */
  public static Optional<Integer> partner(CharSequence text, ElementTree tree, int offset) {
    return tree.at(offset)
        .filter(DocumentElement::open)
        .map(
            element -> {
              int end = endTag(text, element);
              return offset >= end ? element.start() : end;
            });
  }
}
