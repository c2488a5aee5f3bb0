/**
 * What a lab wants done: the study file.
 *
 * <p>In: {@code study.json}, JSON with comments. Out: a {@link
 * org.selectiverenderer.experiment.study.Study}, or what is wrong with the file, by line and
 * column; and the folder of a new study, which is the thesis's. The keys are published as a JSON
 * Schema, {@code study.schema.json}, beside the file.
 *
 * <p>Uses {@code experiment.questionnaire} for what may be asked, {@code control} for the
 * conditions, {@code hmd} for the ways of showing, {@code tracker} and {@code runtime.walk} for
 * their spellings, {@code x3d.files} for what scenes may name, and {@code base} for files and
 * problems. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.experiment.study;

import org.jspecify.annotations.NullMarked;
