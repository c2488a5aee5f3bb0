/**
 * The study file, which defines an experiment.
 *
 * <p>In: {@code study.json}, JSON with comments. Out: a {@link
 * org.selectiverenderer.study.definition.Study}, or the faults of the file by line and column; and
 * the folder of a new study, from the template of the thesis's. The keys are published as a JSON
 * Schema, {@code study.schema.json}, beside the file.
 *
 * <p>Uses {@code study.questionnaire} for the kinds of questionnaires, {@code control} for the
 * conditions, {@code hmd} for displays, {@code tracker} and {@code browser.navigation} for their
 * spellings, {@code x3d.url} for the files that scenes may refer to, and {@code base} for files and
 * problems. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.study.definition;

import org.jspecify.annotations.NullMarked;
