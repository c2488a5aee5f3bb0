package org.selectiverenderer.render.preview;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;

/**
 * A box drawn over a preview: edges, fainter where something hides them, and translucent sides.
 *
 * @param place the matrix from the cube of side 1 about the origin to the world
 * @param edges r, g, b, a of the edges, each 0..1
 * @param sides r, g, b, a of the sides
 */
public record BoxOverlay(Matrix4dc place, float[] edges, float[] sides) {
  public BoxOverlay {
    place = new Matrix4d(place);
  }
}
