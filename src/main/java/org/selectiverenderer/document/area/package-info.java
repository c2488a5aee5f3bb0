/**
 * The areas of a document where they are in the scene: what an author means by an area is a box in
 * metres in the scene's frame, what the text says is {@code center} and {@code size} of a
 * ProximitySensor in the frame of the Transforms around it (X3D 4.0, 22.4.1 and 10.4.4).
 *
 * <p>{@link org.selectiverenderer.document.area.AreaFrame} is the way from one to the other, read
 * from the text alone. A box stays a box in it: its sides keep to the sensor's own axes, each of
 * which is counted to the axis of the scene that it is nearest to, so that "width" is what the
 * author sees as width under a Transform that turns by 90 degrees too. {@link
 * org.selectiverenderer.document.area.PlacedAreas} lists all areas, which of them lie over each
 * other and which have the same schemas, that is, are parts of one area; {@link
 * org.selectiverenderer.document.area.AreaEdits} adds, places and copies them; {@link
 * org.selectiverenderer.document.area.GridStep} snaps lengths.
 *
 * <p>In: a document, boxes. Out: areas, edits, not yet made. Uses {@code document}, {@code
 * document.enrichment}, {@code document.nodes}, {@code geometry}, {@code polygon.count} for boxes
 * that are turned, {@code schema} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.document.area;

import org.jspecify.annotations.NullMarked;
