/**
 * Nodes whose position or size depends on the size of the picture (X3D 4.0, clause 36): LayoutLayer
 * and LayoutGroup, which lay out rectangles, and ScreenGroup and ScreenFontStyle, which are
 * measured in pixels.
 *
 * <p>In: a {@link org.selectiverenderer.browser.nodes.layout.ViewParameters}, which holds the view
 * volume of a layer and the size of the picture, and the matrix of a group. Out: the matrix of its
 * content. The instance tree asks for it once per instance whenever the view parameters change; a
 * scene without such nodes has no cost. Pixels are desktop pixels: on a high-density display one of
 * them is several physical pixels, so that text stays readable.
 *
 * <p>Uses {@code browser.nodes.group}, {@code browser.scene} and {@code x3d.catalogue}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.layout;

import org.jspecify.annotations.NullMarked;
