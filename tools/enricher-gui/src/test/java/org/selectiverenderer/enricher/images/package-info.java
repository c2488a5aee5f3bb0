/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.enricher.images;

import org.jspecify.annotations.NullMarked;
