package org.selectiverenderer.walkthrough;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.collision.CollisionWorld;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.navigation.KeyboardMouseControls;
import org.selectiverenderer.browser.navigation.NavigationCommand;
import org.selectiverenderer.browser.navigation.NavigationMode;
import org.selectiverenderer.browser.navigation.NavigationMotion;
import org.selectiverenderer.browser.navigation.NavigationParameters;
import org.selectiverenderer.browser.nodes.bindable.ViewpointNode;
import org.selectiverenderer.browser.nodes.group.CollisionNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.browser.viewer.ViewpointFrame;
import org.selectiverenderer.browser.viewer.ViewpointTransition;

/**
 * The user's navigation in a world: obeys the bound NavigationInfo and Viewpoint, and animates the
 * transition whenever another viewpoint is bound. It is confined to the thread that steps the
 * world.
 */
public final class NavigationController implements ViewerMotion {
  private final World world;
  private final KeyboardMouseControls controls;
  private final NodeObserver watch = (node, field) -> stale = true;
  private @Nullable InstanceTree tree;
  private @Nullable Node info;
  private @Nullable Node viewpoint;
  private @Nullable Vector3dc centre;
  private boolean stale;
  private NavigationMotion walker;
  private boolean collisions;
  private @Nullable ViewpointTransition transition;
  private final Matrix4d offset = new Matrix4d();
  private @Nullable Pose last;
  private int jumps;
  private Set<CollisionNode> bumped = Set.of();
  private Set<CollisionNode> pushed = Set.of();

  /** Creates a navigation with collision detection. */
  public NavigationController(World world, KeyboardMouseControls controls) {
    this(world, controls, true);
  }

  /**
   * @param collisions whether collision detection is on at first
   */
  public NavigationController(World world, KeyboardMouseControls controls, boolean collisions) {
    this.world = world;
    this.controls = controls;
    this.collisions = collisions;
    walker = newWalker();
    jumps = world.views().jumps();
  }

  private NavigationMotion newWalker() {
    NavigationMotion made =
        new NavigationMotion(
            new CollisionWorld(world.instances(), world.assets(), world.meshes()), controls);
    made.collisions(collisions);
    return made;
  }

  /** Executes a command of the user, if it is about navigation. */
  public void command(NavigationCommand command) {
    switch (command) {
      case RESET_VIEWPOINT -> world.bindables().bound("Viewpoint").ifPresent(this::go);
      case PREVIOUS_VIEWPOINT -> go(-1);
      case NEXT_VIEWPOINT -> go(+1);
      case LAST_VIEWPOINT -> {
        List<Node> all = world.views().viewpoints();
        if (!all.isEmpty()) {
          go(all.get(all.size() - 1));
        }
      }
      case NEXT_MODE -> nextMode();
      case VIEW_ALL -> viewAll();
      case LOOK_AT -> lookAt();
      case TOGGLE_COLLISIONS -> {
        collisions = !collisions;
        walker.collisions(collisions);
      }
      case TOGGLE_OVERLAY, TOGGLE_FULL_SCREEN, RESET_HEADING, LEAVE -> {
        // The window and the tracker handle these commands.
      }
    }
  }

  private void go(int steps) {
    Pose from = Pose.of(world.viewer());
    world.views().goToViewpoint(steps);
    begin(from, world.time());
  }

  private void go(Node to) {
    Pose from = Pose.of(world.viewer());
    world.views().goTo(to);
    begin(from, world.time());
  }

  /**
   * Moves the viewer to where the whole scene is seen. From WALK it changes to EXAMINE, if that is
   * allowed, because a walking viewer would fall.
   */
  private void viewAll() {
    boolean falls = walker.mode() == NavigationMode.WALK;
    boolean examines = walker.navigation().allows(NavigationMode.EXAMINE);
    Pose from = Pose.of(world.viewer());
    if (walker.mode() != NavigationMode.NONE && (!falls || examines) && world.views().viewAll()) {
      if (falls) {
        walker.mode(NavigationMode.EXAMINE);
      }
      begin(from, world.time());
    }
  }

  private void lookAt() {
    boolean may =
        walker.mode() == NavigationMode.LOOKAT
            || walker.mode() == NavigationMode.EXAMINE
                && walker.navigation().allows(NavigationMode.LOOKAT);
    Pose from = Pose.of(world.viewer());
    if (may && world.views().lookAt()) {
      begin(from, world.time());
    }
  }

  /** Starts the transition to the pose that the viewer was just given. */
  private void begin(Pose from, double time) {
    Optional<Node> bound = world.bindables().bound("NavigationInfo");
    transition =
        new ViewpointTransition(
            from,
            Pose.of(world.viewer()),
            ViewpointTransition.Type.of(
                bound.map(node -> node.strings("transitionType")).orElse(new String[0])),
            time,
            bound.map(NavigationController::transitionTime).orElse(1.0));
    world
        .bindables()
        .bound("Viewpoint")
        .ifPresent(
            node ->
                world
                    .views()
                    .poseOf(node)
                    .invertAffine(offset)
                    .mul(Pose.of(world.viewer()).matrix()));
    from.applyTo(world.viewer());
    last = from;
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

  /** Returns the current navigation type. */
  public NavigationMode mode() {
    return walker.mode();
  }

  /** Returns the navigation type as text for the overlay. */
  public String describe() {
    return "%s%s".formatted(walker.mode(), walker.collisions() ? "" : ", through walls");
  }

  @Override
  public void move(Viewer viewer, double time, double dt) {
    follow();
    if (world.views().jumps() != jumps) {
      jumps = world.views().jumps();
      if (last != null) {
        begin(last, time);
      }
    }
    if (transition != null) {
      pass(transition, viewer, time, dt);
    } else {
      walker.move(viewer, time, dt);
      Set<CollisionNode> met = walker.bumped();
      met.addAll(pushed);
      pushed = Set.of();
      tellCollisions(met);
    }
    last = Pose.of(viewer);
  }

  /**
   * Moves the viewer by a physical movement of the user, as far as collision detection allows.
   *
   * @param viewer the viewer at the avatar's eyes, which is moved
   * @param way displacement in world coordinates
   * @return whether the navigation type lets the viewer move; otherwise it stays
   */
  public boolean push(Viewer viewer, Vector3dc way) {
    if (transition != null || !walker.push(viewer, way)) {
      return false;
    }
    pushed = walker.bumped();
    last = Pose.of(viewer);
    return true;
  }

  private void pass(ViewpointTransition way, Viewer viewer, double time, double dt) {
    ViewpointTransition going = target(way);
    going.move(viewer, time, dt);
    transition = going;
    if (going.done(time)) {
      transition = null;
      world
          .bindables()
          .bound("NavigationInfo")
          .ifPresent(
              node -> world.cascade().emit(node, node.type().indexOf("transitionComplete"), true));
    }
  }

  /**
   * Returns the transition to the present pose of the viewpoint, which may move in the meantime.
   */
  private ViewpointTransition target(ViewpointTransition way) {
    return viewpoint == null
        ? way
        : way.to(way.end().at(world.views().poseOf(viewpoint).mul(offset, new Matrix4d())));
  }

  /** Tells Collision nodes when the viewer begins and ceases to collide with their children. */
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

  /** Adapts to another scene, NavigationInfo or Viewpoint, and to changes of their fields. */
  private void follow() {
    boolean another = tree != world.instances();
    if (another) {
      tree = world.instances();
      walker = newWalker();
      transition = null;
      last = null;
      jumps = world.views().jumps();
    }
    Node boundInfo = world.bindables().bound("NavigationInfo").orElse(null);
    Node boundViewpoint = world.bindables().bound("Viewpoint").orElse(null);
    boolean keeps = !another && boundInfo == info;
    Vector3dc middle = world.views().centre().orElse(null);
    if (!keeps || boundViewpoint != viewpoint || middle != centre || stale) {
      centre = middle;
      info = watched(boundInfo, info);
      viewpoint = watched(boundViewpoint, viewpoint);
      stale = false;
      use(keeps);
    }
  }

  private @Nullable Node watched(@Nullable Node now, @Nullable Node before) {
    if (before != null) {
      before.removeObserver(watch);
    }
    if (now != null) {
      now.addObserver(watch);
    }
    return now;
  }

  /**
   * @param keeps whether the NavigationInfo is still the same: then the user's navigation type
   *     stays, unless the author's types have changed
   */
  private void use(boolean keeps) {
    NavigationParameters navigation =
        info == null ? NavigationParameters.WALKING : NavigationParameters.of(info);
    Node from = viewpoint;
    ViewpointFrame frame =
        from == null ? ViewpointFrame.WORLD : ViewpointFrame.of(world.views().placeOf(from));
    if (keeps && navigation.modes().equals(walker.navigation().modes())) {
      walker.adapt(navigation, frame);
    } else {
      walker.use(navigation, frame);
    }
    Vector3dc middle = centre;
    if (info == null && from instanceof ViewpointNode known && known.viewAll()) {
      walker.mode(NavigationMode.EXAMINE); // Without a NavigationInfo a walking viewer would fall.
    }
    if (middle != null) {
      walker.pivot(middle);
    } else if (from instanceof ViewpointNode known) {
      known
          .centerOfRotation()
          .ifPresent(
              center -> walker.pivot(world.views().placeOf(known).transformPosition(center)));
    }
  }
}
