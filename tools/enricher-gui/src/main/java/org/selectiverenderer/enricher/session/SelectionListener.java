package org.selectiverenderer.enricher.session;

import java.util.Optional;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Hears what is selected. */
@FunctionalInterface
public interface SelectionListener {
  /**
   * Another element is selected, or none.
   *
   * @param origin the view that did it, which need not follow; others bring the element into view
   */
  void selected(Optional<DocumentElement> element, Object origin);
}
