/**
 * The Swing windows of a session: form, questionnaires, trials, and the experimenter's controls.
 *
 * <p>In: questionnaires, messages, answers so far. Out: each answer as it is given. Windows run on
 * Swing's event thread; the thread that opens one waits. Uses {@code study.questionnaire}, {@code
 * study.session} and {@code study.definition}.
 */
@NullMarked
package org.selectiverenderer.app.window;

import org.jspecify.annotations.NullMarked;
