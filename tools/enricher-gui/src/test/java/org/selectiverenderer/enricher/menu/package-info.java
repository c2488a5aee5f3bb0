/** Tests of the context menu. */
@NullMarked
package org.selectiverenderer.enricher.menu;

import org.jspecify.annotations.NullMarked;
