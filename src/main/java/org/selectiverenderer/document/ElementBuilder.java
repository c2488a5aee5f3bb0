package org.selectiverenderer.document;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.ElementListener;

/** Builds elements of what the scanner tells. */
final class ElementBuilder implements ElementListener {
  private final int shift;
  private final long revision;
  private @Nullable DocumentElement root;
  private @Nullable DocumentElement open;

  /**
   * @param shift what is added to every offset
   */
  ElementBuilder(int shift, long revision) {
    this.shift = shift;
    this.revision = revision;
  }

  @Override
  public void start(Tag tag) {
    DocumentElement element =
        new DocumentElement(
            tag.name(),
            tag.attribute("DEF"),
            tag.attribute("USE"),
            tag.start() + shift,
            tag.end() + shift,
            revision);
    if (open == null) {
      root = element;
    } else {
      open.add(element);
    }
    open = element;
  }

  @Override
  public void end(int offset) {
    if (open != null) {
      open.endAt(offset + shift);
      open = open.parent().orElse(null);
    }
  }

  /** The root element; the scanner has told of one unless it has failed. */
  DocumentElement root() {
    if (root == null) {
      throw new IllegalStateException("no element has been told of");
    }
    return root;
  }
}
