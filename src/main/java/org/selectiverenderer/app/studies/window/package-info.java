/**
 * The study window of the experimenter, in Swing: studies opened lately, and for an open one the
 * start of a session with who comes next, the plan, the sessions, the rehearsal and the results.
 *
 * <p>{@code StudyDesk} holds the open study and starts commands; pages show it and call it, all on
 * Swing's event thread. {@code BackgroundReader} reads files on the thread {@code study-reader}.
 * Every action stands in an {@code ActionLine}, with the command line that does the same. Theme,
 * text size and language are those of the enricher's window. No OpenGL is started here.
 */
@NullMarked
package org.selectiverenderer.app.studies.window;

import org.jspecify.annotations.NullMarked;
