package org.selectiverenderer.browser.collision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.navigation.MotionRequest;
import org.selectiverenderer.browser.navigation.NavigationMode;
import org.selectiverenderer.browser.navigation.NavigationMotion;
import org.selectiverenderer.browser.navigation.NavigationParameters;
import org.selectiverenderer.browser.nodes.group.CollisionNode;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.TestMeshes;

class CollisionNodesTest {
  private final TestWorld world = new TestWorld();
  private final Viewer viewer = new Viewer();
  private final Mesh wall = TestMeshes.box(-5, 0, -0.1, 5, 3, 0);

  /** How far somebody comes who walks from the origin along -Z for five seconds. */
  private double walk(NavigationMotion walker) {
    viewer.moveTo(new Vector3d(0, 1.6, 0));
    for (int i = 0; i < 300; i++) {
      world.tree();
      walker.move(viewer, i / 60.0, 1 / 60.0);
    }
    return -viewer.position().z();
  }

  private NavigationMotion walker() {
    return new NavigationMotion(world.colliders(), dt -> MotionRequest.ahead(1));
  }

  private Node wallAt(double z) {
    return world.moved(0, 0, z, world.shape(wall));
  }

  @Test
  void whatIsBelowADisabledCollisionDoesNotHoldTheViewerUp() {
    CollisionNode inner = world.collision(null, wallAt(-2));
    CollisionNode outer = world.collision(null, inner);
    world.add(outer);
    NavigationMotion walker = walker();
    assertThat(walk(walker)).isBetween(1.749, 1.751);
    world.set(outer, "enabled", false);
    assertThat(walk(walker)).isGreaterThan(4.9);
    world.set(outer, "enabled", true);
    assertThat(walk(walker)).isBetween(1.749, 1.751);
  }

  /** It goes with the viewer, in front of it: else nobody could look down without falling up. */
  @Test
  void whatIsLaidOutInThePictureDoesNotHoldTheViewerUp() {
    world.add(world.group("LayoutGroup", wallAt(-2)));
    assertThat(walk(walker())).isGreaterThan(4.9);
  }

  @Test
  void aProxyStandsForTheChildrenAndIsNotDrawn() {
    CollisionNode collision = world.collision(wallAt(-3), wallAt(-2));
    world.add(world.moved(0, 0, -1, collision));
    assertThat(walk(walker())).isBetween(3.749, 3.751);
    assertThat(world.tree().shapes()).hasSize(1);
    assertThat(world.rays().cast(new Vector3d(0, 1, 0), new Vector3d(0, 0, -1), 100))
        .map(RayCaster.Hit::distance)
        .contains(3.0);
  }

  @Test
  void aProxyFollowsTheTransformAboveAndAChangeInItself() {
    GroupingNode inside = world.moved(0, 0, -3, world.shape(wall));
    GroupingNode outside = world.moved(0, 0, 0, world.collision(inside));
    world.add(outside);
    NavigationMotion walker = walker();
    assertThat(walk(walker)).isBetween(2.749, 2.751);
    world.set(outside, "translation", new float[] {0, 0, 1});
    assertThat(walk(walker)).isBetween(1.749, 1.751);
    world.set(inside, "translation", new float[] {0, 0, -4});
    assertThat(walk(walker)).isBetween(2.749, 2.751);
  }

  @Test
  void theCollisionNodesBumpedIntoAreNamed() {
    CollisionNode front = world.collision(null, wallAt(-2));
    CollisionNode aside = world.collision(null, world.moved(20, 0, -2, world.shape(wall)));
    world.add(front, aside);
    NavigationMotion walker = walker();
    viewer.moveTo(new Vector3d(0, 1.6, 0));
    walker.move(viewer, 0, 1 / 60.0);
    assertThat(walker.bumped()).isEmpty();
    walk(walker);
    assertThat(walker.bumped()).containsExactly(front);
  }

  @Test
  void whatASwitchHidesOrRemovalTakesAwayIsNoObstacle() {
    GroupingNode door = world.group("Switch", wallAt(-2));
    world.add(door);
    NavigationMotion walker = walker();
    assertThat(walk(walker)).isGreaterThan(4.9);
    world.set(door, "whichChoice", 0);
    assertThat(walk(walker)).isLessThan(1.76);
    world.set(world.root, "children", List.of());
    assertThat(walk(walker)).isGreaterThan(4.9);
  }

  @Test
  void aWallThatAppearsInTheViewerLetsItWalkAwayButNotThrough() {
    GroupingNode door = world.group("Switch", wallAt(-0.1));
    world.add(door);
    NavigationMotion walker = walker();
    viewer.moveTo(new Vector3d(0, 1.6, 0));
    walker.move(viewer, 0, 0);
    world.set(door, "whichChoice", 0);
    assertThat(walk(walker)).isLessThan(0.1);
    NavigationMotion back = new NavigationMotion(world.colliders(), dt -> MotionRequest.ahead(-1));
    assertThat(walk(back)).isLessThan(-4.5);
  }

  @Test
  void readsTheAvatarOfANavigationInfo() {
    Node info = world.node("NavigationInfo");
    world.set(info, "avatarSize", new float[] {0.5f});
    NavigationParameters navigation = NavigationParameters.of(info);
    assertThat(navigation)
        .isEqualTo(
            new NavigationParameters(
                List.of(NavigationMode.EXAMINE, NavigationMode.ANY), 0.5, 1.6, 0.75, 1));
    assertThat(navigation.initial()).isEqualTo(NavigationMode.EXAMINE);
    assertThat(navigation.allows(NavigationMode.WALK)).isTrue();
    world.set(info, "type", new String[] {"HOVER", "NONE"});
    assertThat(NavigationParameters.of(info).initial()).isEqualTo(NavigationMode.NONE);
    assertThat(NavigationParameters.of(info).allows(NavigationMode.WALK)).isFalse();
    world.set(info, "avatarSize", new float[] {0, Float.NaN, -1});
    assertThat(NavigationParameters.of(info).radius()).isPositive();
    assertThat(NavigationParameters.of(info).height()).isPositive();
    assertThat(NavigationParameters.of(info).step()).isZero();
  }
}
