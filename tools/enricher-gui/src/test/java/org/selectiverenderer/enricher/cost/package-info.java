/** Tests of what is said of the cost. */
@NullMarked
package org.selectiverenderer.enricher.cost;

import org.jspecify.annotations.NullMarked;
