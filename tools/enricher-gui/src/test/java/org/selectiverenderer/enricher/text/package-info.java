/** Tests of the enricher without widgets. */
@NullMarked
package org.selectiverenderer.enricher.text;

import org.jspecify.annotations.NullMarked;
