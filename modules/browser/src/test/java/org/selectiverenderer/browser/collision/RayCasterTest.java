package org.selectiverenderer.browser.collision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.joml.Intersectiond;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.TestMeshes;

class RayCasterTest {
  private static final double FAR = Double.POSITIVE_INFINITY;
  private static final Vector3d ORIGIN = new Vector3d(0, 0, 10);
  private static final Vector3d AHEAD = new Vector3d(0, 0, -1);

  private final TestWorld world = new TestWorld();
  private final Mesh cube = TestMeshes.box(-1, -1, -1, 1, 1, 1);

  @Test
  void theNearerOfTwoShapesIsHit() {
    Node near = world.shape(cube);
    Node far = world.shape(cube);
    world.add(world.moved(0, 0, -5, far), near);
    RayCaster.Hit hit = world.rays().cast(ORIGIN, AHEAD, FAR).orElseThrow();
    assertThat(hit.shape().node()).isSameAs(near);
    assertThat(hit.distance()).isEqualTo(9);
    assertThat(hit.point().distance(0, 0, 1)).isLessThan(1e-12);
    assertThat(hit.normal().distance(0, 0, 1)).isLessThan(1e-12);
  }

  @Test
  void distanceAndNormalAreTheWorldsWhateverTheScale() {
    GroupingNode transform = world.group("Transform", world.shape(cube));
    world.set(transform, "scale", new float[] {2, 3, 0.5f});
    world.add(transform);
    RayCaster rays = world.rays();
    RayCaster.Hit hit = rays.cast(ORIGIN, new Vector3d(0, 0, -7), FAR).orElseThrow();
    assertThat(hit.distance()).isCloseTo(9.5, within(1e-9));
    assertThat(hit.normal().distance(0, 0, 1)).isLessThan(1e-9);
    assertThat(rays.cast(ORIGIN, AHEAD, 9.4)).isEmpty();
  }

  @Test
  void whatMovedIsHitWhereItIsNow() {
    GroupingNode transform = world.moved(0, 0, 0, world.shape(cube));
    world.add(transform);
    RayCaster rays = world.rays();
    assertThat(rays.cast(ORIGIN, AHEAD, FAR)).isPresent();
    world.set(transform, "translation", new float[] {50, 0, 0});
    world.tree();
    assertThat(rays.cast(ORIGIN, AHEAD, FAR)).isEmpty();
    assertThat(rays.cast(new Vector3d(50, 0, 10), AHEAD, FAR)).isPresent();
  }

  @Test
  void onlyTheChoiceOfASwitchIsHitAndWhatIsAddedIsFound() {
    Node first = world.shape(cube);
    Node second = world.shape(cube);
    GroupingNode chooser = world.group("Switch", first, second);
    world.add(chooser);
    RayCaster rays = world.rays();
    assertThat(rays.cast(ORIGIN, AHEAD, FAR)).isEmpty();
    world.set(chooser, "whichChoice", 1);
    world.tree();
    assertThat(rays.cast(ORIGIN, AHEAD, FAR).orElseThrow().shape().node()).isSameAs(second);
    Node added = world.shape(cube);
    world.add(world.moved(0, 0, 4, added));
    world.tree();
    assertThat(rays.cast(ORIGIN, AHEAD, FAR).orElseThrow().shape().node()).isSameAs(added);
  }

  @Test
  void backsOfSolidGeometryAreNotHitEvenWhenMirrored() {
    GroupingNode mirror = world.group("Transform", world.shape(cube));
    world.set(mirror, "scale", new float[] {1, 1, -1});
    world.add(mirror);
    RayCaster rays = world.rays();
    assertThat(rays.cast(ORIGIN, AHEAD, FAR)).map(RayCaster.Hit::distance).contains(9.0);
    assertThat(rays.cast(new Vector3d(), AHEAD, FAR)).isEmpty();
  }

  @Test
  void aTwoSidedSurfaceFacesTheRayAndKnowsItsTextureCoordinate() {
    world.add(TestMeshes.quad(false, -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0));
    RayCaster rays = world.rays();
    RayCaster.Hit behind =
        rays.cast(new Vector3d(0.5, 0, -3), new Vector3d(0, 0, 1), FAR).orElseThrow();
    assertThat(behind.normal().z()).isCloseTo(-1, within(1e-12));
    Vector2d texCoord = behind.texCoord();
    assertThat(texCoord).isNotNull();
    assertThat(texCoord.distance(0.75, 0.5)).isLessThan(1e-9);
  }

  @Test
  void aShapeScaledToNothingAndARayWithoutDirectionHitNothing() {
    GroupingNode flat = world.group("Transform", world.shape(cube));
    world.set(flat, "scale", new float[] {0, 0, 0});
    world.add(flat);
    assertThat(world.rays().cast(ORIGIN, AHEAD, FAR)).isEmpty();
    assertThat(world.rays().cast(ORIGIN, new Vector3d(), FAR)).isEmpty();
  }

  @Test
  void amongThousandsOfMovingShapesTheNearestIsFound() {
    Random random = new Random(4);
    List<GroupingNode> transforms = new ArrayList<>();
    for (int i = 0; i < 2000; i++) {
      transforms.add(world.moved(0, 0, 0, world.shape(cube)));
    }
    world.add(transforms.toArray(Node[]::new));
    RayCaster rays = world.rays();
    for (int round = 0; round < 6; round++) {
      for (GroupingNode transform : transforms) {
        float[] to = {place(random), place(random), place(random)};
        world.set(transform, "translation", to);
      }
      world.tree();
      for (int i = 0; i < 100; i++) {
        Vector3d origin = new Vector3d(place(random), place(random), place(random));
        Vector3d direction = new Vector3d(place(random), place(random), place(random)).normalize();
        assertThat(rays.cast(origin, direction, FAR).map(RayCaster.Hit::distance).orElse(-1.0))
            .isCloseTo(nearest(transforms, origin, direction), within(1e-6));
      }
    }
  }

  private static float place(Random random) {
    return random.nextFloat() * 100 - 50;
  }

  /** The nearest box that the ray enters from outside. */
  private static double nearest(
      List<GroupingNode> transforms, Vector3d origin, Vector3d direction) {
    double nearest = -1;
    for (GroupingNode transform : transforms) {
      float[] t = transform.floats("translation");
      Vector3d min = new Vector3d(t[0] - 1.0, t[1] - 1.0, t[2] - 1.0);
      Vector3d max = new Vector3d(t[0] + 1.0, t[1] + 1.0, t[2] + 1.0);
      Vector2d at = new Vector2d();
      if (Intersectiond.intersectRayAab(origin, direction, min, max, at)
          && at.x >= 0
          && (nearest < 0 || at.x < nearest)) {
        nearest = at.x;
      }
    }
    return nearest;
  }
}
