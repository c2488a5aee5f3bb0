/**
 * Tests of {@code enricher.ratings}: its logic without a window, then its window driven by a robot.
 */
@NullMarked
package org.selectiverenderer.enricher.ratings;

import org.jspecify.annotations.NullMarked;
