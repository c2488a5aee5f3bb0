/**
 * What the study window knows and does, without a window: the state of an open study with who comes
 * next, what a journal tells of a running session, and the commands that the window starts.
 *
 * <p>In: a study's files. Out: a {@link org.selectiverenderer.app.studies.StudyOverview} and a
 * {@link org.selectiverenderer.app.studies.SessionProgress}, which are values, and commands. Every
 * action is a command of the program, so that the window does what a terminal does. Uses {@code
 * app.process}, {@code study} and {@code base}; {@code app.studies.window} shows it.
 */
@NullMarked
package org.selectiverenderer.app.studies;

import org.jspecify.annotations.NullMarked;
