/**
 * Runs the open document, saved or not, in a process of its own, as its visitors will see it.
 *
 * <p>{@code ProcessLauncher} starts a command of the program with the Java, flags and class path of
 * this process. {@code RunInputFile} provides the file that the command reads: the document's own
 * if it is saved and the run begins at the start viewpoint; else a temporary copy beside it, so
 * that relative urls resolve, with the preview's pose as a viewpoint if the author runs from there.
 * A copy lives as long as its run. {@code SceneRunManager} owns the processes, each with a thread
 * {@code enricher-run} that reads its output; they end with the window, and with this process
 * however it ends. {@code InlineFileResolver} resolves the file that an Inline names, for opening
 * it.
 *
 * <p>In: snapshots of the document, the preview's pose, the author's choice. Out: processes, their
 * messages. Everything but those threads belongs to the event dispatch thread. Uses {@code
 * enricher.session}, {@code enricher.text}, {@code authoring}, {@code control} for the names of
 * conditions, {@code browser.viewer}, {@code x3d}, {@code base}.
 */
@NullMarked
package org.selectiverenderer.enricher.run;

import org.jspecify.annotations.NullMarked;
