/**
 * The scene as its visitors will see it: {@code run} on the open document, saved or not, in a
 * process of its own.
 *
 * <p>{@code Launcher} starts a command of the program with the Java, flags and class path of this
 * one. {@code RunScene} says which file the command reads: the document's own if that is as it is
 * on the disk and the run begins where the scene begins; else a copy beside it, so that urls mean
 * the same, with the viewpoint of the preview if the author runs from there. A copy lives as long
 * as its run. {@code SceneRuns} owns the processes, each with a thread {@code enricher-run} that
 * hears its messages; they end with the window, and with this process whatever ends it. {@code
 * InlineTarget} says which file an Inline means, for opening it.
 *
 * <p>In: snapshots of the document, the preview's pose, the author's choice. Out: processes, their
 * messages. Everything but those threads belongs to the event dispatch thread. Uses {@code
 * enricher.session}, {@code enricher.text}, {@code document}, {@code control} for the names of
 * conditions, {@code runtime.viewer}, {@code x3d}, {@code base}.
 */
@NullMarked
package org.selectiverenderer.enricher.run;

import org.jspecify.annotations.NullMarked;
