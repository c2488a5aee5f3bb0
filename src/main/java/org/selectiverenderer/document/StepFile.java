package org.selectiverenderer.document;

import java.nio.file.Path;

/**
 * A file that a step of the author's writes beside the document's own.
 *
 * @param content after the step
 * @param byHand whether what is replaced was not made by this program, so that it cannot be made
 *     again: it is kept beside the file besides
 */
public record StepFile(Path file, byte[] content, boolean byHand) {}
