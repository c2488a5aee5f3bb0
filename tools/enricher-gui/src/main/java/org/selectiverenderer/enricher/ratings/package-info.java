/**
 * Importing expectancy ratings (thesis 5.1, Appendix A): read, matched to Switches, reviewed,
 * applied as one step.
 *
 * <p>In: RATINGS.csv. Out: one edit. Uses {@code enricher.session}, {@code enricher.table}, {@code
 * enricher.task}, {@code document}, {@code schema} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.enricher.ratings;

import org.jspecify.annotations.NullMarked;
