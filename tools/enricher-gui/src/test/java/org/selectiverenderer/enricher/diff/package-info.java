/**
 * Tests of {@code enricher.diff}: its logic without a window, then its window driven by a robot.
 */
@NullMarked
package org.selectiverenderer.enricher.diff;

import org.jspecify.annotations.NullMarked;
