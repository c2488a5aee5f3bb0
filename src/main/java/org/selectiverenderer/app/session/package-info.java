/**
 * A participant's session with real windows: the steps that {@code study.session} knows, each shown
 * by the same run loop as {@code run} shows a scene.
 *
 * <p>{@link org.selectiverenderer.app.run.RunSequence} shows one run after the other in windows
 * that stay open. A session's exposure is a run with a {@link
 * org.selectiverenderer.app.run.RunController}, which decides when it ends, how dark the picture is
 * and what the operator's window shows. JOGL starts while AWT is headless, and Swing is allowed
 * afterwards, because each uses its own X connection.
 *
 * <p>With a headset, questions may be a run of the same chain: {@link
 * org.selectiverenderer.app.session.HeadsetQuestionController} turns presses of buttons into
 * answers, and {@link org.selectiverenderer.app.session.QuestionPanelRenderer} lays out the text.
 * The participant's progress is kept by {@code study.questionnaire}, for windows and headset alike.
 *
 * <p>A trial of a block is one run of the chain, too: {@link
 * org.selectiverenderer.app.session.TrialController} goes through the phases by the clock of the
 * frames ({@link org.selectiverenderer.study.design.TrialCourse} decides when each ends), holds the
 * choices of Switches, and draws texts and questions into the picture by {@code app.session}'s
 * pages. Windows stay open from trial to trial; only another display opens new ones.
 *
 * <p>In: a {@link org.selectiverenderer.study.session.Session} begun or resumed, and a {@link
 * org.selectiverenderer.app.session.SessionUi}, which asks participant and experimenter. Out: the
 * session's files, and how it ended. Uses {@code app.run} with its settings and measurements,
 * {@code app.head}, {@code study}, {@code hmd}, {@code control}, {@code tracker}, {@code browser}
 * and {@code base}; Swing is behind the dialogue.
 */
@NullMarked
package org.selectiverenderer.app.session;

import org.jspecify.annotations.NullMarked;
