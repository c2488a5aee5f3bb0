/** Tests of the enricher without widgets. */
@NullMarked
package org.selectiverenderer.enricher.source;

import org.jspecify.annotations.NullMarked;
