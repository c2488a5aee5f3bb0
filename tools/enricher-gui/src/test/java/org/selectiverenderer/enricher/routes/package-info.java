/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.enricher.routes;

import org.jspecify.annotations.NullMarked;
