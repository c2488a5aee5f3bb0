/**
 * Tests of {@code enricher.versions}: its logic without a window, then its window driven by a
 * robot.
 */
@NullMarked
package org.selectiverenderer.enricher.versions;

import org.jspecify.annotations.NullMarked;
