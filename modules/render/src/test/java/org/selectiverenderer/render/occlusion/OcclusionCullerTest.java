package org.selectiverenderer.render.occlusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.geometry.mesh.Mesh;

/** The eye is at the origin and looks along -Z, a right angle wide, 100 x 100 pixels. */
class OcclusionCullerTest {
  /** Nothing, but of that size: what is asked about. */
  private static final Mesh EIGHTEEN_METRES =
      new Mesh(
          Mesh.Primitive.TRIANGLES,
          new float[0],
          null,
          null,
          null,
          new int[0],
          true,
          new float[] {-9, -9, -9, 9, 9, 9});

  private static final Matrix4dc HERE = new Matrix4d();
  private static final double[] BEHIND = {-0.5, -0.5, -6, 0.5, 0.5, -5};
  private static final int[] QUAD = {0, 1, 2, 0, 2, 3};

  private static Camera camera(Matrix4dc view) {
    return new Camera(
        view, new Matrix4d().setPerspective(Math.PI / 2, 1, 0.1, 100), 0, 0, 100, 100);
  }

  private static Mesh mesh(boolean solid, float[] points, int... indices) {
    float[] bounds = Mesh.boundsOf(points, indices);
    return new Mesh(Mesh.Primitive.TRIANGLES, points, null, null, null, indices, solid, bounds);
  }

  /** Two units to each side, facing +Z. */
  private static float[] wall(float z) {
    return new float[] {-2, -2, z, 2, -2, z, 2, 2, z, -2, 2, z};
  }

  private static boolean hides(Mesh mesh, Matrix4dc world, double[] box, Camera... eyes) {
    OcclusionCuller occlusion = new OcclusionCuller();
    occlusion.begin(List.of(eyes), false);
    double inf = 1e3;
    occlusion.offer(MeshOccluders.of(mesh), world, new double[] {-inf, -inf, -inf, inf, inf, inf});
    if (!occlusion.cover()) {
      return false;
    }
    occlusion.ask(HERE, MeshOccluders.of(EIGHTEEN_METRES));
    return IntStream.range(0, eyes.length).allMatch(eye -> occlusion.hides(eye, box, 0));
  }

  private static boolean hides(Mesh mesh, double[] box) {
    return hides(mesh, HERE, box, camera(HERE));
  }

  @Test
  void aWallHidesWhatIsBehindIt() {
    Mesh wall = mesh(true, wall(-3), QUAD);
    assertThat(hides(wall, BEHIND)).isTrue();
    assertThat(hides(wall, new double[] {-0.5, -0.5, -3, 0.5, 0.5, -2})).isFalse();
    assertThat(hides(wall, new double[] {-0.5, -0.5, -6, 0.5, 0.5, -2.9})).isFalse();
    assertThat(hides(wall, new double[] {3.4, -0.5, -6, 4.4, 0.5, -5})).isFalse();
    // Touching it from behind is too close to tell.
    assertThat(hides(wall, new double[] {-0.5, -0.5, -4, 0.5, 0.5, -3})).isFalse();
  }

  @Test
  void theBackOfASolidWallHidesNothing() {
    int[] back = {0, 2, 1, 0, 3, 2};
    assertThat(hides(mesh(true, wall(-3), back), BEHIND)).isFalse();
    assertThat(hides(mesh(false, wall(-3), back), BEHIND)).isTrue();
  }

  @Test
  void mirroringKeepsTheFrontInLocalCoordinates() {
    // Along X the wall turns no face; along Z it shows its back.
    Mesh wall = mesh(true, wall(-3), QUAD);
    assertThat(hides(wall, new Matrix4d().scale(-1, 1, 1), BEHIND, camera(HERE))).isTrue();
    Mesh inFront = mesh(true, wall(3), QUAD);
    assertThat(hides(inFront, new Matrix4d().scale(1, 1, -1), BEHIND, camera(HERE))).isFalse();
    Mesh flat = mesh(true, wall(0), QUAD);
    assertThat(hides(flat, new Matrix4d().translation(0, 0, -3), BEHIND, camera(HERE))).isTrue();
    assertThat(hides(flat, new Matrix4d().scale(0, 1, 1), BEHIND, camera(HERE))).isFalse();
  }

  @Test
  void oneSeesThroughASlit() {
    // Two walls in one mesh, 0.1 mm apart: far less than a pixel.
    float[] points = {
      -2, -2, -3, 0, -2, -3, 0, 2, -3, -2, 2, -3, 1e-4f, -2, -3, 2, -2, -3, 2, 2, -3, 1e-4f, 2, -3
    };
    int[] both = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    assertThat(hides(mesh(true, points, both), BEHIND)).isFalse();
    assertThat(hides(mesh(true, points, both), new double[] {1, -0.5, -6, 2, 0.5, -5})).isTrue();
    points[12] = 0;
    points[21] = 0;
    assertThat(hides(mesh(true, points, both), BEHIND)).isTrue();
  }

  @Test
  void aSharedEdgeWithACornerOfOnlyOneSideIsNoClosedOne() {
    float[] points = {-2, -2, -3, 0, -2, -3, 0, 2, -3, -2, 2, -3, 2, -2, -3, 2, 2, -3, 0, 0.3f, -3};
    int[] halves = {0, 1, 2, 0, 2, 3, 1, 4, 6, 6, 4, 5, 6, 5, 2};
    assertThat(hides(mesh(true, points, halves), BEHIND)).isFalse();
  }

  @Test
  void degenerateTrianglesChangeNothing() {
    assertThat(hides(mesh(true, wall(-3), 0, 0, 1, 0, 1, 2, 3, 3, 3, 0, 2, 3), BEHIND)).isTrue();
    assertThat(hides(mesh(true, wall(-3), 0, 1, 1), BEHIND)).isFalse();
  }

  @Test
  void wallsThatPassTheEyeAreCutAtTheNearPlane() {
    // A floor one unit below, from behind the eye to far ahead.
    float[] floor = {-50, -1, 50, 50, -1, 50, 50, -1, -50, -50, -1, -50};
    Mesh mesh = mesh(true, floor, QUAD);
    assertThat(hides(mesh, new double[] {-1, -4, -6, 1, -3, -5})).isTrue();
    assertThat(hides(mesh, new double[] {-1, -4, -6, 1, -0.9, -5})).isFalse();
    assertThat(hides(mesh, new double[] {-1, -4, -6, 1, -3, 1})).isFalse();
  }

  @Test
  void anEyeInAWallOrInABoxSeesOn() {
    assertThat(hides(mesh(false, wall(0), QUAD), BEHIND)).isFalse();
    assertThat(hides(mesh(false, wall(-0.05f), QUAD), BEHIND)).isFalse();
    assertThat(hides(mesh(true, wall(-3), QUAD), new double[] {-1, -1, -9, 1, 1, 1})).isFalse();
  }

  @Test
  void eachEyeIsAskedAbout() {
    Mesh wall = mesh(true, new float[] {-1, -1, -3, 1, -1, -3, 1, 1, -3, -1, 1, -3}, QUAD);
    double[] box = {-0.2, -0.2, -6, 0.2, 0.2, -5};
    Camera aside = camera(new Matrix4d().translation(-3, 0, 0));
    assertThat(hides(wall, HERE, box, camera(HERE))).isTrue();
    assertThat(hides(wall, HERE, box, camera(HERE), aside)).isFalse();
  }

  @Test
  void inParallelProjectionsNothingIsHidden() {
    Camera parallel =
        new Camera(HERE, new Matrix4d().setOrtho(-2, 2, -2, 2, 0.1, 100), 0, 0, 100, 100);
    assertThat(hides(mesh(true, wall(-3), QUAD), HERE, BEHIND, parallel)).isFalse();
  }

  @Test
  void numbersTooLargeToDrawSharplyHideNothing() {
    float far = 1 << 24;
    float[] points = {far - 2, -2, -3, far + 2, -2, -3, far + 2, 2, -3, far - 2, 2, -3};
    Matrix4d back = new Matrix4d().translation(-far, 0, 0);
    assertThat(hides(mesh(true, points, QUAD), back, BEHIND, camera(HERE))).isFalse();
  }

  @Test
  void whatStandsAlongAWallIsHiddenAlsoFromAslant() {
    float[] points = {-20, -20, -3, 20, -20, -3, 20, 20, -3, -20, 20, -3};
    Mesh wall = mesh(true, points, QUAD);
    for (double degrees : new double[] {-40, -20, 20, 40}) {
      Camera aslant = camera(new Matrix4d().rotationY(Math.toRadians(degrees)));
      assertThat(hides(wall, HERE, new double[] {-1, -0.5, -4, 1, 0.5, -3.2}, aslant)).isTrue();
      assertThat(hides(wall, HERE, new double[] {-1, -0.5, -4, 1, 0.5, -2.9}, aslant)).isFalse();
      assertThat(hides(wall, HERE, new double[] {-1, -0.5, -2.9, 1, 0.5, -2}, aslant)).isFalse();
    }
    Camera down = camera(new Matrix4d().rotationX(Math.toRadians(30)));
    assertThat(hides(wall, HERE, new double[] {-1, -2.5, -4, 1, 0.5, -3.2}, down)).isTrue();
    assertThat(hides(wall, HERE, new double[] {-1, -2.5, -4, 1, 0.5, -2.9}, down)).isFalse();
  }
}
