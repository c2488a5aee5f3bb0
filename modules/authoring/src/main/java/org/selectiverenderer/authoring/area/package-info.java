/**
 * The areas of a document with their positions in the scene: to an author an area is a box in
 * metres in scene coordinates; the text contains {@code center} and {@code size} of a
 * ProximitySensor in the coordinates of the enclosing Transforms (X3D 4.0, 22.4.1 and 10.4.4).
 *
 * <p>{@link org.selectiverenderer.authoring.area.LocalCoordinateSystem} is the transformation
 * between the two, read from the text alone. A box stays a box: its sides are parallel to the
 * sensor's axes, each of which is assigned to the nearest axis of the scene, so that "width" is
 * what the author sees as width also under a Transform that rotates by 90 degrees. {@link
 * org.selectiverenderer.authoring.area.AreaLocator} lists all areas, their overlaps, and those with
 * the same schemas, which are parts of one area; {@link
 * org.selectiverenderer.authoring.area.AreaEdits} adds, places and copies them; {@link
 * org.selectiverenderer.authoring.area.SnapGrid} snaps lengths.
 *
 * <p>In: a document, boxes. Out: areas, edits, not yet made. Uses {@code authoring}, {@code
 * authoring.enrichment}, {@code authoring.nodes}, {@code authoring.structure}, {@code geometry},
 * {@code polygon} for oriented boxes, {@code schema} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.authoring.area;

import org.jspecify.annotations.NullMarked;
