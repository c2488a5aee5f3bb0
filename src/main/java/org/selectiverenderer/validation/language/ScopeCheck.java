package org.selectiverenderer.validation.language;

import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Looks at an element with the names that are known where it stands. */
interface ScopeCheck {
  void check(DocumentElement element, Scopes scopes, Findings findings);
}
