/**
 * The cost of the scene, shown below the table of schemas: polygons, bytes of textures and draw
 * calls of each part of the scene in each state that the areas bring about, against limits that the
 * author sets; and the share of each object.
 *
 * <p>Nothing is counted here: {@link org.selectiverenderer.polygon.IncrementalSceneCounter} counts
 * as {@code polygons} does and keeps the files that have not changed, {@link
 * org.selectiverenderer.validation.budget.BudgetStatus} compares as {@code validate} does, and the
 * limits are the {@code budgets} of the validator's settings file, which {@link
 * org.selectiverenderer.validation.settings.BudgetSettingsEditor} changes in place.
 *
 * <p>The flow: after an edit of the document and a pause, {@code CostUpdater} takes a snapshot to a
 * task of the session, which reads the settings and counts the polygons; the resulting {@code
 * CostRow}s are values and go to {@code CostPanel} on the event dispatch thread. While the panel is
 * hidden and no limit is set, nothing is counted. A limit that is newly exceeded is reported in the
 * status bar; the validator's own finding (SR501) is in the list of problems, since {@code
 * BudgetFileLocator} gives both the same settings.
 *
 * <p>In: the session, the settings file. Out: the settings file, selections. Uses {@code
 * enricher.session}, {@code enricher.settings}, {@code enricher.table}, {@code enricher.text},
 * {@code enricher.images} for sizes in words, {@code polygon}, {@code validation}, {@code base}.
 */
@NullMarked
package org.selectiverenderer.enricher.cost;

import org.jspecify.annotations.NullMarked;
