package org.selectiverenderer.runtime.nodes.layout;

import java.util.Optional;
import org.joml.Matrix4dc;

/** A group whose content lies where the picture says: asked for each of its places. */
public interface Seen {
  /**
   * Where the content of a group goes.
   *
   * @param content from the content's coordinates to the world
   * @param region the rectangle that groups below lie in; empty where it is the one above
   */
  record Spot(Matrix4dc content, Optional<Region> region) {}

  /**
   * The spot of one place.
   *
   * @param world from the group's own coordinates to the world
   * @param above the rectangle that the group lies in; empty for the whole picture
   */
  Spot spot(Matrix4dc world, Sight sight, Optional<Region> above);
}
