package org.selectiverenderer.authoring.versions;

import java.util.List;
import java.util.Set;
import org.joml.Matrix4dc;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * An element of a scene that draws faces, with its size.
 *
 * @param box bounding box in the frame of the parent
 * @param placement transformation from the frame of the children to that of the parent
 * @param shapes the number of shapes and Inlines in it
 * @param children those of its children that draw faces; none for a shape or an Inline
 */
record MeasuredElement(
    DocumentElement element,
    BoundingBox box,
    Matrix4dc placement,
    long polygons,
    int shapes,
    List<MeasuredElement> children) {
  private static final double SPANS = 0.5;
  private static final double SPANS_A_PART = 0.25;

  /** Nodes that stand in rooms, not in pieces of furniture. */
  private static final Set<String> OF_ROOMS =
      Set.of("Switch", "ProximitySensor", "Viewpoint", "OrthoViewpoint", "NavigationInfo");

  /** A piece of furniture that spans the scene has at most so many parts. */
  private static final int MANY = 6;

  private boolean ofRoom() {
    return OF_ROOMS.contains(element.name())
        || element.children().stream().anyMatch(child -> OF_ROOMS.contains(child.name()))
        || children.stream().anyMatch(MeasuredElement::ofRoom);
  }

  /**
   * Returns whether a group is a room, or a part of one, rather than one piece whose shapes belong
   * together. Nothing in a file tells them apart, so this is a guess by size and number.
   *
   * @param scale the largest extent of the group as a share of the scene's
   */
  boolean holdsPieces(double scale) {
    if (children.isEmpty()) {
      return false;
    }
    if (children.size() == 1) {
      MeasuredElement only = children.get(0);
      return !only.children.isEmpty()
          && (only.holdsPieces(scale) || element.def().isEmpty() && only.element.def().isPresent());
    }
    if (children.stream().anyMatch(MeasuredElement::ofRoom)
        || element.children().stream().anyMatch(child -> OF_ROOMS.contains(child.name()))) {
      return true;
    }
    long composed = children.stream().filter(child -> child.shapes > 1).count();
    return scale >= SPANS && (composed >= 1 || children.size() > MANY)
        || scale >= SPANS_A_PART && composed >= 2;
  }
}
