package org.selectiverenderer.browser.camera;

import java.util.List;
import org.joml.Matrix4dc;

/**
 * A flat panel placed in the world, for example a questionnaire, which both eyes see in front of
 * everything else.
 *
 * @param marks the primitives on the panel, in coordinates from its upper left corner, +Y down
 * @param place the matrix from the panel's plane to the world
 */
public record WorldSpacePanel(List<Primitive2D> marks, Matrix4dc place) {
  public WorldSpacePanel {
    marks = List.copyOf(marks);
  }
}
