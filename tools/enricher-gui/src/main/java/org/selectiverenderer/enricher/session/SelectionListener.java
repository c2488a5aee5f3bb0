package org.selectiverenderer.enricher.session;

import java.util.Optional;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Listens to the selection of a session. */
@FunctionalInterface
public interface SelectionListener {
  /**
   * Another element is selected, or none.
   *
   * @param origin the view that selected it, which need not follow; other views show the element
   */
  void selected(Optional<DocumentElement> element, Object origin);
}
