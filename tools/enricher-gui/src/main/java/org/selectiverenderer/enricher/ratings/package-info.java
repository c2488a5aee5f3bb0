/**
 * The import of expectancy ratings (thesis 5.1, Appendix A): reads a table, matches its objects to
 * Switches, shows the implied metadata and applies it as one undo step.
 *
 * <p>In: RATINGS.csv. Out: one edit. Uses {@code enricher.session}, {@code enricher.table}, {@code
 * enricher.task}, {@code authoring}, {@code schema} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.enricher.ratings;

import org.jspecify.annotations.NullMarked;
