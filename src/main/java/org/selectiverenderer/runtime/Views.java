package org.selectiverenderer.runtime;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4dc;
import org.joml.Vector3dc;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.runtime.nodes.bind.ViewpointNode;
import org.selectiverenderer.runtime.scene.Node;

/**
 * Where the viewer of a world can be taken: to the viewpoints of the scene, to where all of it or a
 * part of it is seen. In a scene with layers, of the active one. Belongs to the thread that steps
 * the world.
 */
public final class Views {
  private final World world;

  Views(World world) {
    this.world = world;
  }

  private ViewpointFollower follower() {
    return world.stack().active().follower;
  }

  /** Moves the viewer to a viewpoint of the scene: binds it and forgets where the user went. */
  public void goTo(Node viewpoint) {
    world.hold(
        () -> {
          world.bindables().bind(viewpoint, world.cascade());
          world.cascade().run();
          follower().jump();
        });
  }

  /**
   * Takes the viewer to where all that is shown is seen at once.
   *
   * @return whether there is anything to see
   */
  public boolean viewAll() {
    boolean[] moved = new boolean[1];
    world.hold(() -> moved[0] = follower().viewAll());
    return moved[0];
  }

  /**
   * Takes the viewer to where the shape that is pointed at is seen as a whole (X3D 4.0, 23.4.4:
   * LOOKAT).
   *
   * @return whether there is one that does nothing by itself when it is clicked on
   */
  public boolean lookAt() {
    boolean[] moved = new boolean[1];
    world.hold(
        () -> {
          Optional<Bounds> box =
              world
                  .stack()
                  .pointedAt(world.latestPointer())
                  .map(shape -> Bounds.of(shape.bounds()));
          box.ifPresent(follower()::look);
          moved[0] = box.isPresent();
        });
    return moved[0];
  }

  /**
   * The middle of what the viewer was taken to see by {@link #viewAll}, {@link #lookAt} or a
   * viewpoint with {@code viewAll}; empty once another viewpoint is bound.
   */
  public Optional<Vector3dc> centre() {
    return follower().centre();
  }

  /**
   * How often the viewer was taken to another viewpoint that an event has bound. Who moves the
   * viewer may make a transition of it (X3D 4.0, 23.3.1).
   */
  public int jumps() {
    return follower().jumps();
  }

  /**
   * The viewpoints of the scene, or of its active layer, in document order; those that a
   * ViewpointGroup hides are left out.
   */
  public List<Node> viewpoints() {
    return world.bindables().all("X3DViewpointNode").stream().filter(follower()::offers).toList();
  }

  /**
   * Goes to a viewpoint counted from the bound one, around the ends of the list.
   *
   * @param steps +1 for the next, -1 for the one before
   */
  public void goToViewpoint(int steps) {
    List<Node> all = viewpoints();
    if (!all.isEmpty()) {
      int at = world.bindables().bound("X3DViewpointNode").map(all::indexOf).orElse(-1);
      goTo(all.get(Math.floorMod(at + steps, all.size())));
    }
  }

  /** Where a viewpoint looks from: takes the viewer's frame, looking along -Z, to the world. */
  public Matrix4dc poseOf(Node viewpoint) {
    return viewpoint instanceof ViewpointNode known
        ? follower().poseOf(known)
        : follower().placeOf(viewpoint);
  }

  /** The place of a viewpoint in the world; the identity when it is in no part of the scene. */
  public Matrix4dc placeOf(Node viewpoint) {
    return follower().placeOf(viewpoint);
  }
}
