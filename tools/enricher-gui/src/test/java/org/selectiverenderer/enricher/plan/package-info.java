/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.enricher.plan;

import org.jspecify.annotations.NullMarked;
