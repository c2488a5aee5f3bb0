/**
 * What can be told about a study before anybody comes: the balance of its plan, how long it takes,
 * and the plan as text, table and picture.
 *
 * <p>In: a {@link org.selectiverenderer.study.session.StudyPlan} and a {@link
 * org.selectiverenderer.study.session.LoadedStudy}. Out: figures, text, CSV, SVG, HTML. Uses {@code
 * study.session}, {@code study.questionnaire}, {@code chart} for the picture, and {@code base}. No
 * GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.study.rehearsal;

import org.jspecify.annotations.NullMarked;
