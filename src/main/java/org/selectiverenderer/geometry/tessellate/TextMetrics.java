package org.selectiverenderer.geometry.tessellate;

/**
 * The extent of a line of text, in the unit of its size.
 *
 * @param width from the origin of the first character to where the next line's would follow
 * @param ascent above the base line
 * @param descent below the base line, positive
 */
public record TextMetrics(float width, float ascent, float descent) {}
