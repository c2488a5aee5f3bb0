/**
 * Importing expectancy ratings (thesis 5.1, Appendix A): read, matched to Switches, reviewed,
 * applied as one step.
 *
 * <p>In: RATINGS.csv. Out: one edit. Uses {@code document.ratings} and {@code enricher.session}.
 */
@NullMarked
package org.selectiverenderer.enricher.ratings;

import org.jspecify.annotations.NullMarked;
