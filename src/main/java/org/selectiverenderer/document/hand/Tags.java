package org.selectiverenderer.document.hand;

import java.util.Optional;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/** Start tags and end tags of well formed text. */
public final class Tags {
  private Tags() {}

  /**
   * Where an element's end tag begins; of one without, where the element does.
   *
   * @param text that it stands in
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
   * Where the tag begins that belongs to the one at an offset: the end tag from anywhere in an
   * element, its start tag from the end tag. Empty outside of the root and for elements of one tag.
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
