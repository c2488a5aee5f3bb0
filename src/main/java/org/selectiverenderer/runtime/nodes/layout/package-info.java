/**
 * Nodes whose place or size depends on the picture that they are seen in (X3D 4.0, clause 36): the
 * rectangles of LayoutLayer and LayoutGroup, and what is measured in pixels, ScreenGroup and the
 * text of a ScreenFontStyle.
 *
 * <p>In: a {@link org.selectiverenderer.runtime.nodes.layout.Sight}, which is what the viewer sees
 * of a layer and how many pixels that is, and where a group stands. Out: where its content goes.
 * The tree of instances asks once for each place, whenever the sight is another; a scene without
 * such nodes is not asked. A pixel is one of the desktop: on a dense display it is several of the
 * picture, so that what is measured in pixels stays readable.
 *
 * <p>Uses {@code runtime.nodes.group}, {@code runtime.scene} and {@code x3d.catalogue}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.layout;

import org.jspecify.annotations.NullMarked;
