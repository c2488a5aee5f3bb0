package org.selectiverenderer.validation.language;

import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.x3d.source.DocumentElement;

/** A check of an element that needs the names visible at its place. */
interface ScopeCheck {
  void check(DocumentElement element, Scopes scopes, Findings findings);
}
