/**
 * The windows of a session that are no scenes: form, questionnaires, the experimenter's controls.
 *
 * <p>In: screens of questions, words, answers so far. Out: answers, one by one, as they are given.
 * Swing, on its event thread; whoever opens a window waits on a thread of his own. Uses {@code
 * experiment.questionnaire}, {@code experiment.session} and {@code experiment.study}.
 */
@NullMarked
package org.selectiverenderer.experiment.window;

import org.jspecify.annotations.NullMarked;
