package org.selectiverenderer.document;

/**
 * Where a text stops being well formed.
 *
 * @param line from 1; 0 when it is the text as a whole
 * @param column from 1, in characters; 0 when unknown
 * @param message the first half of a sentence
 */
public record Fault(int line, int column, String message) {}
