package org.selectiverenderer.browser.nodes.layout;

import java.util.Optional;
import org.joml.Matrix4dc;

/**
 * A group whose layout depends on the viewer and on the size of the picture: LayoutGroup,
 * LayoutLayer, ScreenGroup. It is laid out separately for each of its instances.
 */
public interface ViewDependentLayout {
  /**
   * The layout of one instance of a group.
   *
   * @param content the matrix from the content's coordinates to the world
   * @param region the layout rectangle for the groups below; empty if it is the parent rectangle
   */
  record Spot(Matrix4dc content, Optional<LayoutRectangle> region) {}

  /**
   * Computes the layout of one instance.
   *
   * @param world the matrix from the group's own coordinates to the world
   * @param above the parent rectangle; empty for the whole picture
   */
  Spot spot(Matrix4dc world, ViewParameters sight, Optional<LayoutRectangle> above);
}
