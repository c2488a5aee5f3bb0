/**
 * Questionnaires from files: tables of objects, JSON files of an author's own, and the standard
 * scales that come with the program.
 *
 * <p>In: a file and a language. Out: {@link
 * org.selectiverenderer.experiment.questionnaire.Questionnaire}s, or what is wrong with the file,
 * by line and column; a faulty questionnaire is not used at all, as one with a question missing
 * cannot be compared with the others. The keys of a JSON file are published as a JSON Schema,
 * {@code questionnaire.schema.json}.
 *
 * <p>Uses {@code experiment.questionnaire}, {@code statistics.detection} for the types of objects,
 * {@code hmd} for the bounds of the distance of pupils, and {@code base}. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.experiment.questionnaire.read;

import org.jspecify.annotations.NullMarked;
