package org.selectiverenderer.validation.language;

import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.source.DocumentElement;

/** A check of an element that needs the names visible at its place. */
interface NameScopeCheck {
  void check(DocumentElement element, NameScopes scopes, FindingCollector findings);
}
