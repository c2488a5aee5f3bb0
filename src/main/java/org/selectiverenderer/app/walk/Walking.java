package org.selectiverenderer.app.walk;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.collide.Colliders;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.nodes.bind.ViewpointNode;
import org.selectiverenderer.runtime.nodes.group.CollisionNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.viewer.NavigationFrame;
import org.selectiverenderer.runtime.viewer.Pose;
import org.selectiverenderer.runtime.viewer.Viewer;
import org.selectiverenderer.runtime.viewer.ViewerMotion;
import org.selectiverenderer.runtime.viewer.ViewpointTransition;
import org.selectiverenderer.runtime.walk.Controls;
import org.selectiverenderer.runtime.walk.Navigation;
import org.selectiverenderer.runtime.walk.NavigationCommand;
import org.selectiverenderer.runtime.walk.NavigationMode;
import org.selectiverenderer.runtime.walk.Walker;

/**
 * The user's walking through a world: follows the bound NavigationInfo and viewpoint, and goes from
 * viewpoint to viewpoint. Belongs to the thread that steps the world.
 */
public final class Walking implements ViewerMotion {
  private final World world;
  private final Controls controls;
  private @Nullable InstanceTree tree;
  private @Nullable Node info;
  private @Nullable Node viewpoint;
  private Walker walker;
  private @Nullable ViewpointTransition transition;
  private Set<CollisionNode> bumped = Set.of();

  public Walking(World world, Controls controls) {
    this.world = world;
    this.controls = controls;
    walker = new Walker(new Colliders(world.instances(), world.assets(), world.meshes()), controls);
  }

  /** Does what the user asked for, as far as it is about moving. */
  public void command(NavigationCommand command) {
    switch (command) {
      case RESET_VIEWPOINT ->
          world.bindables().bound("Viewpoint").ifPresent(bound -> go(() -> world.goTo(bound)));
      case PREVIOUS_VIEWPOINT -> go(() -> world.goToViewpoint(-1));
      case NEXT_VIEWPOINT -> go(() -> world.goToViewpoint(+1));
      case LAST_VIEWPOINT -> {
        List<Node> all = world.viewpoints();
        if (!all.isEmpty()) {
          go(() -> world.goTo(all.get(all.size() - 1)));
        }
      }
      case NEXT_MODE -> nextMode();
      case TOGGLE_COLLISIONS -> walker.collisions(!walker.collisions());
      case TOGGLE_OVERLAY, TOGGLE_FULL_SCREEN, RESET_HEADING, LEAVE -> {
        // The window's and the tracker's own business.
      }
    }
  }

  private void go(Runnable there) {
    Pose from = Pose.of(world.viewer());
    there.run();
    Optional<Node> bound = world.bindables().bound("NavigationInfo");
    transition =
        new ViewpointTransition(
            from,
            Pose.of(world.viewer()),
            ViewpointTransition.Type.of(
                bound.map(node -> node.strings("transitionType")).orElse(new String[0])),
            world.time(),
            bound.map(Walking::transitionTime).orElse(1.0));
    from.applyTo(world.viewer());
  }

  private void nextMode() {
    List<NavigationMode> modes =
        Arrays.stream(NavigationMode.values())
            .filter(mode -> mode != NavigationMode.ANY && walker.navigation().allows(mode))
            .toList();
    if (!modes.isEmpty()) {
      walker.mode(modes.get((modes.indexOf(walker.mode()) + 1) % modes.size()));
    }
  }

  /** What the overlay says about it. */
  public String describe() {
    return "%s%s".formatted(walker.mode(), walker.collisions() ? "" : ", through walls");
  }

  @Override
  public void move(Viewer viewer, double time, double dt) {
    follow();
    if (transition != null) {
      transition.move(viewer, time, dt);
      if (transition.done(time)) {
        transition = null;
      }
      return;
    }
    walker.move(viewer, time, dt);
    tellCollisions(walker.bumped());
  }

  /** Collision nodes hear when the viewer begins and ceases to bump into what is in them. */
  private void tellCollisions(Set<CollisionNode> now) {
    for (CollisionNode node : bumped) {
      if (!now.contains(node)) {
        node.collide(false, world.cascade());
      }
    }
    now.forEach(node -> node.collide(true, world.cascade()));
    bumped = now;
  }

  private static double transitionTime(Node navigationInfo) {
    return navigationInfo.value("transitionTime") instanceof Double seconds ? seconds : 1;
  }

  /** Adapts to another scene, NavigationInfo or viewpoint. */
  private void follow() {
    if (tree != world.instances()) {
      tree = world.instances();
      walker = new Walker(new Colliders(tree, world.assets(), world.meshes()), controls);
      info = null;
      viewpoint = null;
      transition = null;
      use(world.bindables().bound("NavigationInfo"), world.bindables().bound("Viewpoint"));
      return;
    }
    Optional<Node> boundInfo = world.bindables().bound("NavigationInfo");
    Optional<Node> boundViewpoint = world.bindables().bound("Viewpoint");
    if (boundInfo.orElse(null) != info || boundViewpoint.orElse(null) != viewpoint) {
      use(boundInfo, boundViewpoint);
    }
  }

  private void use(Optional<Node> boundInfo, Optional<Node> boundViewpoint) {
    info = boundInfo.orElse(null);
    viewpoint = boundViewpoint.orElse(null);
    walker.use(
        boundInfo.map(Navigation::of).orElse(Navigation.WALKING),
        boundViewpoint
            .map(node -> NavigationFrame.of(world.placeOf(node)))
            .orElse(NavigationFrame.WORLD));
    boundViewpoint
        .filter(ViewpointNode.class::isInstance)
        .flatMap(node -> ((ViewpointNode) node).centerOfRotation())
        .ifPresent(center -> walker.pivot(world.placeOf(viewpoint).transformPosition(center)));
  }
}
