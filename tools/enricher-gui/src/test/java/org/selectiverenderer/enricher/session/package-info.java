/** Tests of the enricher without widgets. */
@NullMarked
package org.selectiverenderer.enricher.session;

import org.jspecify.annotations.NullMarked;
