package org.selectiverenderer.runtime.nodes.layout;

/**
 * The size of a layout's rectangle; its middle is the origin of what is in it.
 *
 * @param width in the world's unit of length
 * @param height in the world's unit of length
 */
public record Region(double width, double height) {}
