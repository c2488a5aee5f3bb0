/**
 * Readers of questionnaires: tables of items, JSON files, and the standard questionnaires that come
 * with the program.
 *
 * <p>In: a file and a language. Out: {@link
 * org.selectiverenderer.study.questionnaire.Questionnaire}s, or the faults of the file by line and
 * column; a faulty questionnaire is not used at all, as answers to one that lacks a question cannot
 * be compared with the others. The keys of a JSON file are published as a JSON Schema, {@code
 * questionnaire.schema.json}.
 *
 * <p>Uses {@code study.questionnaire}, {@code statistics.detection} for the types of items, {@code
 * hmd} for the limits of the interpupillary distance, and {@code base}. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.study.questionnaire.read;

import org.jspecify.annotations.NullMarked;
