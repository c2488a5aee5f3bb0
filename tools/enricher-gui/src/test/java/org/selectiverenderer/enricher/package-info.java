/** Tests of the whole window of the enricher. */
@NullMarked
package org.selectiverenderer.enricher;

import org.jspecify.annotations.NullMarked;
