package org.selectiverenderer.runtime.camera;

import java.util.List;
import org.joml.Matrix4dc;

/**
 * A page that stands in the world, seen by both eyes before everything else.
 *
 * @param marks on it, measured from its upper left corner, +Y down
 * @param place takes the page's plane to the world
 */
public record Panel(List<Mark> marks, Matrix4dc place) {
  public Panel {
    marks = List.copyOf(marks);
  }
}
