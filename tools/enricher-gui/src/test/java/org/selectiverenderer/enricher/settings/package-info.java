/** Tests of the enricher without widgets. */
@NullMarked
package org.selectiverenderer.enricher.settings;

import org.jspecify.annotations.NullMarked;
