package org.selectiverenderer.browser;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4dc;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.nodes.bindable.ViewpointNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * Moves the viewer of a world to viewpoints of the scene, or to where the whole scene or a shape is
 * in view. In a scene with layers this concerns the active layer. Belongs to the thread that steps
 * the world.
 */
public final class ViewpointNavigator {
  private final World world;

  ViewpointNavigator(World world) {
    this.world = world;
  }

  private ViewpointFollower follower() {
    return world.stack().active().follower;
  }

  /** Moves the viewer to a viewpoint of the scene: binds it and drops the user's offset. */
  public void goTo(Node viewpoint) {
    world.hold(
        () -> {
          world.bindables().bind(viewpoint, world.cascade());
          world.cascade().run();
          follower().jump();
        });
  }

  /**
   * Moves the viewer to where the whole scene is in view.
   *
   * @return whether the scene shows any shape
   */
  public boolean viewAll() {
    boolean[] moved = new boolean[1];
    world.hold(() -> moved[0] = follower().viewAll());
    return moved[0];
  }

  /**
   * Moves the viewer to where the whole shape under the pointer is in view (X3D 4.0, 23.4.4:
   * LOOKAT).
   *
   * @return whether there is such a shape without a sensor or Anchor that takes the click
   */
  public boolean lookAt() {
    boolean[] moved = new boolean[1];
    world.hold(
        () -> {
          Optional<BoundingBox> box =
              world
                  .stack()
                  .pointedAt(world.latestPointer())
                  .map(shape -> BoundingBox.of(shape.bounds()));
          box.ifPresent(follower()::look);
          moved[0] = box.isPresent();
        });
    return moved[0];
  }

  /**
   * Returns the centre of the box framed by {@link #viewAll}, {@link #lookAt} or a viewpoint with
   * {@code viewAll}; empty once another viewpoint is bound.
   */
  public Optional<Vector3dc> centre() {
    return follower().centre();
  }

  /**
   * Returns how often an event has bound a viewpoint and moved the viewer there. Code that moves
   * the viewer may animate such a jump as a transition (X3D 4.0, 23.3.1).
   */
  public int jumps() {
    return follower().jumps();
  }

  /**
   * Returns the viewpoints of the scene, or of its active layer, in document order, without those
   * that a ViewpointGroup hides.
   */
  public List<Node> viewpoints() {
    return world.bindables().all("X3DViewpointNode").stream().filter(follower()::offers).toList();
  }

  /**
   * Moves the viewer to a viewpoint counted from the bound one; the list wraps around.
   *
   * @param steps +1 for the next viewpoint, -1 for the previous one
   */
  public void goToViewpoint(int steps) {
    List<Node> all = viewpoints();
    if (!all.isEmpty()) {
      int at = world.bindables().bound("X3DViewpointNode").map(all::indexOf).orElse(-1);
      goTo(all.get(Math.floorMod(at + steps, all.size())));
    }
  }

  /**
   * Returns a viewpoint's pose: the matrix from the viewer's frame, looking along -Z, to the world.
   */
  public Matrix4dc poseOf(Node viewpoint) {
    return viewpoint instanceof ViewpointNode known
        ? follower().poseOf(known)
        : follower().placeOf(viewpoint);
  }

  /**
   * Returns the matrix from a viewpoint's local coordinates to the world; the identity if the
   * viewpoint is in no part of the scene.
   */
  public Matrix4dc placeOf(Node viewpoint) {
    return follower().placeOf(viewpoint);
  }
}
