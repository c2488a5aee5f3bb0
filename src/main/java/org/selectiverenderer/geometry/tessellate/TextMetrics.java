package org.selectiverenderer.geometry.tessellate;

/**
 * The extent of a line of text, in the unit of its size.
 *
 * @param width the advance width of the line
 * @param ascent the ascent above the baseline
 * @param descent the descent below the baseline, positive
 */
public record TextMetrics(float width, float ascent, float descent) {}
