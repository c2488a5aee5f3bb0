/**
 * The import of expectancy ratings (thesis 5.1, Appendix A): reads a table, matches its objects to
 * Switches, shows the implied metadata and applies it as one undo step. Beside them, what is
 * proposed from the head logs of participants.
 *
 * <p>In: RATINGS.csv, head logs. Out: one edit; {@link
 * org.selectiverenderer.enricher.ratings.GazeProposals}, which joins the logs of {@code study.gaze}
 * with the scene of {@code authoring}, needs no window and is the command's, too. Uses {@code
 * enricher.session}, {@code enricher.table}, {@code enricher.task}, {@code authoring}, {@code
 * study.gaze}, {@code schema} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.enricher.ratings;

import org.jspecify.annotations.NullMarked;
