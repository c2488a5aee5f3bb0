package org.selectiverenderer.render.lighting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.instance.Light;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.mesh.RefinedMesh;

class MeshRefinerTest {
  private static final double TOLERANCE = 1.2 / 255;
  private static final CurvatureTolerance ANY = CurvatureTolerance.NONE;

  /** A floor of ten by ten in y = 0 around the origin, of two triangles, that faces up. */
  private static Mesh floor(boolean solid) {
    float[] positions = {-5, 0, -5, -5, 0, 5, 5, 0, 5, 5, 0, -5};
    float[] normals = {0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0};
    float[] texCoords = {0, 0, 0, 1, 1, 1, 1, 0};
    return mesh(positions, normals, texCoords, new int[] {0, 1, 2, 0, 2, 3}, solid);
  }

  /**
   * A roof of two slopes that meet in a seam: its vertices lie at the same points, but their
   * normals differ.
   */
  private static Mesh roof() {
    float s = (float) Math.sqrt(0.5);
    float[] positions = {
      -5, 0, 5, 5, 0, 5, 5, 5, 0, -5, 5, 0, -5, 5, 0, 5, 5, 0, 5, 0, -5, -5, 0, -5
    };
    float[] normals = {0, s, s, 0, s, s, 0, s, s, 0, s, s, 0, s, -s, 0, s, -s, 0, s, -s, 0, s, -s};
    int[] indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    return mesh(positions, normals, new float[16], indices, true);
  }

  private static Mesh mesh(
      float[] positions, float[] normals, float[] texCoords, int[] indices, boolean solid) {
    return new Mesh(
        Mesh.Primitive.TRIANGLES,
        positions,
        normals,
        null,
        texCoords,
        indices,
        solid,
        Mesh.boundsOf(positions, indices));
  }

  private static WorldSpaceLight point(double x, double y, double z, double radius) {
    return light(Light.Kind.POINT, new Vector3d(x, y, z), radius, 9, 10);
  }

  /** A light that shines down. */
  private static WorldSpaceLight light(
      Light.Kind kind, Vector3d at, double radius, double beamWidth, double cutOff) {
    return new WorldSpaceLight(
        kind,
        at,
        new Vector3d(0, -1, 0),
        new Vector3d(1, 1, 1),
        0.8,
        0,
        1,
        0,
        0.05,
        radius,
        beamWidth,
        cutOff);
  }

  private static MeshRefiner.Result refine(
      Mesh mesh, CurvatureTolerance fineness, WorldSpaceLight... lights) {
    return MeshRefiner.refine(
        mesh,
        mesh.normals(),
        new Matrix4d(),
        fineness,
        new DiffuseLightModel(List.of(lights)),
        MeshMetrics.of(mesh).longest(),
        TOLERANCE);
  }

  private static double light(WorldSpaceLight light, double[] p) {
    double[] out = new double[3];
    new DiffuseLightModel(List.of(light)).add(p[0], p[1], p[2], p[3], p[4], p[5], out, 0);
    return out[0];
  }

  /** Of all triangles, in their middles: the largest departure of interpolated light. */
  private static double worst(Mesh mesh, WorldSpaceLight light) {
    double worst = 0;
    int[] indices = mesh.indices();
    for (int i = 0; i < indices.length; i += 3) {
      double[] middle = new double[6];
      double straight = 0;
      for (int k = 0; k < 3; k++) {
        double[] corner = new double[6];
        for (int axis = 0; axis < 3; axis++) {
          corner[axis] = mesh.positions()[3 * indices[i + k] + axis];
          corner[3 + axis] = mesh.normals()[3 * indices[i + k] + axis];
        }
        straight += light(light, corner) / 3;
        for (int axis = 0; axis < 6; axis++) {
          middle[axis] += corner[axis] / 3;
        }
      }
      worst = Math.max(worst, Math.abs(light(light, middle) - straight));
    }
    return worst;
  }

  private static double area(Mesh mesh) {
    double sum = 0;
    int[] t = mesh.indices();
    for (int i = 0; i < t.length; i += 3) {
      Vector3d a = at(mesh, t[i]);
      sum += at(mesh, t[i + 1]).sub(a).cross(at(mesh, t[i + 2]).sub(a)).length() / 2;
    }
    return sum;
  }

  private static Vector3d at(Mesh mesh, int v) {
    float[] p = mesh.positions();
    return new Vector3d(p[3 * v], p[3 * v + 1], p[3 * v + 2]);
  }

  /** How many triangles have each pair of points as an edge. */
  private static Map<List<Vector3d>, Integer> edges(Mesh mesh) {
    Map<List<Vector3d>, Integer> edges = new HashMap<>();
    int[] t = mesh.indices();
    for (int i = 0; i < t.length; i++) {
      Vector3d a = at(mesh, t[i]);
      Vector3d b = at(mesh, t[i % 3 == 2 ? i - 2 : i + 1]);
      boolean turned = a.x != b.x ? a.x > b.x : a.y != b.y ? a.y > b.y : a.z > b.z;
      edges.merge(turned ? List.of(b, a) : List.of(a, b), 1, Integer::sum);
    }
    return edges;
  }

  @Test
  void withoutALightThatIsNearAFlatFaceStaysAsItIs() {
    Mesh floor = floor(true);
    assertThat(refine(floor, ANY).mesh()).isSameAs(floor);
    assertThat(refine(floor, ANY, point(0, 400, 0, 1000)).mesh()).isSameAs(floor);
    assertThat(refine(floor, ANY, point(0, 4, 0, 3)).mesh()).isSameAs(floor);
  }

  @Test
  void underALampAFaceIsSplitUntilItsLightIsThatOfItsPixels() {
    WorldSpaceLight lamp = point(1, 2, 0.5, 100);
    MeshRefiner.Result result = refine(floor(true), ANY, lamp);
    assertThat(worst(floor(true), lamp)).isGreaterThan(20.0 / 255);
    assertThat(worst(result.mesh(), lamp)).isLessThan(4.0 / 255);
    assertThat(result.complete()).isTrue();
    assertThat(result.forLight()).isTrue();
    assertThat(area(result.mesh())).isCloseTo(100, within(1e-3));
  }

  @Test
  void everyStageHasTheWholeSurfaceAndTheFirstIsTheMeshItself() {
    Mesh floor = floor(true);
    RefinedMesh staged = refine(floor, ANY, point(1, 2, 0.5, 100)).staged();
    Mesh last = staged.mesh();
    List<RefinedMesh.Stage> coarser = staged.coarser();
    assertThat(coarser).hasSizeGreaterThan(2);
    assertThat(coarser.get(0).indices()).isEqualTo(floor.indices());
    assertThat(coarser.get(0).undivided()).isCloseTo(Math.sqrt(200), within(1e-5));
    for (int i = 0; i < coarser.size(); i++) {
      int[] indices = coarser.get(i).indices();
      int[] next = i + 1 < coarser.size() ? coarser.get(i + 1).indices() : last.indices();
      Mesh stage =
          mesh(last.positions(), last.normals(), new float[2 * last.vertexCount()], indices, true);
      assertThat(area(stage)).isCloseTo(100, within(1e-3));
      assertThat(indices.length).isLessThan(next.length);
      assertThat(coarser.get(i).undivided())
          .isLessThanOrEqualTo(MeshMetrics.of(stage).longest() + 1e-5)
          .isGreaterThanOrEqualTo(i + 1 < coarser.size() ? coarser.get(i + 1).undivided() : 0);
    }
  }

  @Test
  void aBeamInTheMiddleOfAFaceWithDarkCornersIsFound() {
    WorldSpaceLight spot = light(Light.Kind.SPOT, new Vector3d(1.7, 1.5, 2.1), 50, 0.3, 0.6);
    MeshRefiner.Result result = refine(floor(true), ANY, spot);
    assertThat(result.mesh().polygons()).isGreaterThan(100);
    assertThat(result.complete()).isTrue();
    assertThat(worst(result.mesh(), spot)).isLessThan(8.0 / 255);
  }

  @Test
  void aStepOfLightIsLeftToThePixels() {
    assertThat(refine(floor(true), ANY, point(0, 2, 0, 3)).complete()).isFalse();
  }

  @Test
  void theSideBehindCountsWhereItIsSeen() {
    WorldSpaceLight below = point(0, -2, 0, 100);
    assertThat(refine(floor(true), ANY, below).forLight()).isFalse();
    assertThat(refine(floor(false), ANY, below).forLight()).isTrue();
  }

  @Test
  void noCracksOpenAndNoneBetweenTheSidesOfASeam() {
    // The light is behind the ridge for one of the slopes, which alone would not be split.
    Mesh refined = refine(roof(), ANY, point(0, 4, 4, 100)).mesh();
    assertThat(refined.polygons()).isGreaterThan(50);
    assertThat(area(refined)).isCloseTo(area(roof()), within(1e-3));
    edges(refined)
        .forEach(
            (ends, triangles) -> {
              boolean ridge = ends.get(0).y == 5 && ends.get(1).y == 5;
              boolean eaves = ends.get(0).y == 0 && ends.get(1).y == 0;
              boolean gable = Math.abs(ends.get(0).x) == 5 && ends.get(0).x == ends.get(1).x;
              assertThat(triangles).as("%s", ends).isEqualTo(eaves || gable ? 1 : 2);
              assertThat(ridge && triangles == 1).isFalse();
            });
  }

  @Test
  void normalsStayUnitVectorsAndCoordinatesOfTheImageHalve() {
    Mesh refined = refine(floor(true), ANY, point(0, 2, 0, 100)).mesh();
    float[] texCoords = refined.texCoords();
    for (int v = 0; v < refined.vertexCount(); v++) {
      Vector3d p = at(refined, v);
      assertThat(texCoords[2 * v]).isCloseTo((float) (p.x + 5) / 10, within(1e-5f));
      assertThat(texCoords[2 * v + 1]).isCloseTo((float) (p.z + 5) / 10, within(1e-5f));
      assertThat(refined.normals()[3 * v + 1]).isEqualTo(1);
    }
  }

  @Test
  void aBentSurfaceIsSplitUntilItsNormalsLieNear() {
    float s = (float) Math.sin(0.6);
    float c = (float) Math.cos(0.6);
    float[] positions = {-1, 0, 0, -1, 1, 0, 1, 1, 0, 1, 0, 0};
    float[] normals = {-s, 0, c, -s, 0, c, s, 0, c, s, 0, c};
    Mesh arch = mesh(positions, normals, new float[8], new int[] {0, 3, 2, 0, 2, 1}, true);
    CurvatureTolerance fine = new CurvatureTolerance(CurvatureTolerance.WIDE, 0.02);
    Mesh refined = refine(arch, fine).mesh();
    assertThat(MeshMetrics.of(arch).bent()).isGreaterThan(0.5);
    assertThat(MeshMetrics.of(refined).bent()).isLessThanOrEqualTo(0.02);
    assertThat(refined.polygons()).isLessThan(200);
  }

  @Test
  void theSameComesOutEveryTime() {
    WorldSpaceLight lamp = point(1, 2, 0.5, 100);
    Mesh once = refine(roof(), ANY, lamp).mesh();
    Mesh again = refine(roof(), ANY, lamp).mesh();
    assertThat(again.indices()).isEqualTo(once.indices());
    assertThat(again.positions()).isEqualTo(once.positions());
  }
}
