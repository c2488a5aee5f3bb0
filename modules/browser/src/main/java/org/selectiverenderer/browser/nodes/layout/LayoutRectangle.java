package org.selectiverenderer.browser.nodes.layout;

/**
 * The size of a layout rectangle; its centre is the origin of its content.
 *
 * @param width the width in world units
 * @param height the height in world units
 */
public record LayoutRectangle(double width, double height) {}
