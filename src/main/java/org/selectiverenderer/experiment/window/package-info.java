/**
 * The Swing windows of a session: form, questionnaires, trials, and the experimenter's controls.
 *
 * <p>In: questionnaires, messages, answers so far. Out: each answer as it is given. Windows run on
 * Swing's event thread; the thread that opens one waits. Uses {@code experiment.questionnaire},
 * {@code experiment.session} and {@code experiment.study}.
 */
@NullMarked
package org.selectiverenderer.experiment.window;

import org.jspecify.annotations.NullMarked;
