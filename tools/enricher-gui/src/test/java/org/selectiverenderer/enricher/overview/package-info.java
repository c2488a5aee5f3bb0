/**
 * Tests of {@code enricher.overview}: its logic without a window, then its window driven by a
 * robot.
 */
@NullMarked
package org.selectiverenderer.enricher.overview;

import org.jspecify.annotations.NullMarked;
