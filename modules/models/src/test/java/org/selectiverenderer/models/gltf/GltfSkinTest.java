package org.selectiverenderer.models.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/**
 * A triangle whose first vertex follows a hip, its second an arm, its third both. Nodes: 0 the
 * mesh, 1 a scaled Transform, 2 the hip in it, 3 a turned Transform in the hip, 4 the arm.
 */
class GltfSkinTest extends GltfSceneTest {
  private static final Quaterniond QUARTER = new Quaterniond().rotateZ(Math.PI / 2);

  private final Matrix4d scaled = new Matrix4d().translate(0, 1, 0).scale(2);
  private final Matrix4d hip = new Matrix4d().translate(1, 0, 0).rotate(QUARTER);
  private final Matrix4d between = new Matrix4d().translate(0, 0, 3).rotateX(0.5);
  private final Matrix4d hipBound = new Matrix4d().translate(0.5, 0.5, 0).rotateY(1).scale(0.5);
  private final Matrix4d armBound = new Matrix4d().translate(0, 2, 1).rotateX(1).scale(3);

  private final GltfBuilder gltf =
      new GltfBuilder()
          .triangle()
          .floats("MAT4", 2, matrices())
          .shorts("VEC4", 3, "", 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0)
          .floats("VEC4", 3, 1, 0, 0, 0, 1, 0, 0, 0, 0.25f, 0.75f, 0, 0)
          .floats("VEC3", 3, 0, 0, 1, 0, 0, 1, 0, 0, 1)
          .floats("SCALAR", 2, 0, 2)
          .floats("VEC4", 2, 0, 0, 0, 1, (float) Math.sin(1), 0, 0, (float) Math.cos(1))
          .floats("VEC3", 2, 0, 5, 0, 0, 5, 4);

  private float[] matrices() {
    float[] all = new float[32];
    hipBound.invert(new Matrix4d()).get(all, 0);
    armBound.invert(new Matrix4d()).get(all, 16);
    return all;
  }

  private static String matrix(Matrix4d matrix) {
    double[] m = matrix.get(new double[16]);
    StringBuilder text = new StringBuilder();
    for (double value : m) {
      text.append(text.length() == 0 ? "" : ",").append(value);
    }
    return text.toString();
  }

  private X3dFile skinned(String more) throws IOException {
    return read(
        gltf.json(
            """
            "scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"skin":0,"translation":[9,9,9]},
              {"matrix":[%s],"children":[2]},{"name":"hip","matrix":[%s],"children":[3]},
              {"matrix":[%s],"children":[4]},{"name":"arm","translation":[0,5,0]}],
            "skins":[{"joints":[2,4],"inverseBindMatrices":1}],
            "meshes":[{"primitives":[{"attributes":
              {"POSITION":0,"NORMAL":4,"JOINTS_0":2,"WEIGHTS_0":3}}]}]%s"""
                .formatted(matrix(scaled), matrix(hip), matrix(between), more)));
  }

  private static final class Posed {
    private final List<Vector3d> sums = new ArrayList<>();

    Posed(ParsedNode humanoid) {
      float[] points = humanoid.node("skinCoord").floats("point");
      for (int i = 0; i < points.length; i += 3) {
        sums.add(new Vector3d());
      }
      humanoid.nodes("skeleton").forEach(node -> add(node, new Matrix4d(), points));
    }

    /** Moves points as X3D 4.0, 26.2.4 and 10.4.4 (Transform) say. */
    private void add(NodeView joint, Matrix4d above, float[] points) {
      Vector3d c = vector(joint.floats("center"));
      Quaterniond so = turn(joint.floats("scaleOrientation"));
      Matrix4d placed =
          new Matrix4d(above)
              .translate(vector(joint.floats("translation")))
              .translate(c)
              .rotate(turn(joint.floats("rotation")))
              .rotate(so)
              .scale(vector(joint.floats("scale")))
              .rotate(so.conjugate(new Quaterniond()))
              .translate(c.negate(new Vector3d()));
      int[] vertices = joint.ints("skinCoordIndex");
      float[] weights = joint.floats("skinCoordWeight");
      for (int i = 0; i < vertices.length; i++) {
        int v = 3 * vertices[i];
        Vector3d at = new Vector3d(points[v], points[v + 1], points[v + 2]);
        sums.get(vertices[i]).fma(weights[i], placed.transformPosition(at));
      }
      joint.nodes("children").forEach(child -> add(child, placed, points));
    }

    private static Vector3d vector(float[] xyz) {
      return new Vector3d(xyz[0], xyz[1], xyz[2]);
    }

    private static Quaterniond turn(float[] r) {
      return new Quaterniond().fromAxisAngleRad(r[0], r[1], r[2], r[3]);
    }
  }

  /** Returns where glTF 2.0, 3.7.3.3 shows the vertices. */
  private List<Vector3d> expected(Matrix4d arm) {
    Matrix4d hipPlace = new Matrix4d(scaled).mul(hip);
    Matrix4d armPlace = new Matrix4d(hipPlace).mul(between).mul(arm);
    Matrix4d byHip = hipPlace.mul(hipBound.invert(new Matrix4d()));
    Matrix4d byArm = armPlace.mul(armBound.invert(new Matrix4d()));
    Vector3d last = byHip.transformPosition(new Vector3d(0, 1, 0)).mul(0.25);
    last.fma(0.75, byArm.transformPosition(new Vector3d(0, 1, 0)));
    return List.of(
        byHip.transformPosition(new Vector3d()),
        byArm.transformPosition(new Vector3d(1, 0, 0)),
        last);
  }

  private static void assertNear(List<Vector3d> actual, List<Vector3d> expected) {
    for (int i = 0; i < expected.size(); i++) {
      assertThat(actual.get(i).distance(expected.get(i)))
          .as("vertex %d is at %s, not at %s", i, actual.get(i), expected.get(i))
          .isCloseTo(0, within(1e-4));
    }
  }

  @Test
  void aSkinAtRestIsWhereItsJointsAre() throws IOException {
    X3dFile file = skinned("");

    assertNear(
        new Posed(first(file, "HAnimHumanoid")).sums, expected(new Matrix4d().translate(0, 5, 0)));
    assertThat(messages()).isEmpty();
    assertThat(first(file, "HAnimHumanoid").nodes("skin")).hasSize(1);
    assertThat(first(file, "HAnimHumanoid").nodes("joints")).hasSize(4);
  }

  @Test
  void animationsMoveTheJointsOfASkinAndTheTransformOfTheNode() throws IOException {
    X3dFile file =
        skinned(
            """
            ,"animations":[{"channels":[{"sampler":0,"target":{"node":4,"path":"rotation"}},
              {"sampler":1,"target":{"node":4,"path":"translation"}}],
             "samplers":[{"input":5,"output":6},{"input":5,"output":7}]}]""");

    ParsedNode arm =
        all(file, "HAnimJoint").stream()
            .filter(joint -> joint.ints("skinCoordIndex").length == 2)
            .reduce((former, later) -> later)
            .orElseThrow();
    for (X3dFile.ParsedRoute route : file.routes()) {
      if (route.to() == arm) {
        float[] keys = route.from().floats("keyValue");
        float[] last = new float[keys.length / 2];
        System.arraycopy(keys, last.length, last, 0, last.length);
        arm.put(route.toField(), last);
      }
    }
    Matrix4d moved = new Matrix4d().translate(0, 5, 4).rotateX(2);
    assertNear(new Posed(first(file, "HAnimHumanoid")).sums, expected(moved));
    assertThat(file.routes().stream().map(route -> route.to().type().name()))
        .contains("HAnimJoint", "Transform");
    assertThat(messages()).isEmpty();
  }

  @Test
  void aSkinThatWasBoundWhereItRestsStaysInPlaceWithoutItsJoints() throws IOException {
    hipBound.set(scaled).mul(hip);
    armBound.set(hipBound).mul(between).translate(0, 5, 0);
    X3dFile file =
        read(
            new GltfBuilder()
                .triangle()
                .floats("MAT4", 2, matrices())
                .shorts("VEC4", 3, "", 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0)
                .floats("VEC4", 3, 1, 0, 0, 0, 1, 0, 0, 0, 0.25f, 0.75f, 0, 0)
                .json(
                    """
                    "scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"skin":0},
                      {"matrix":[%s],"children":[2]},{"matrix":[%s],"children":[3]},
                      {"matrix":[%s],"children":[4]},{"translation":[0,5,0]}],
                    "skins":[{"joints":[2,4],"inverseBindMatrices":1}],
                    "meshes":[{"primitives":[{"attributes":
                      {"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3}}]}]"""
                        .formatted(matrix(scaled), matrix(hip), matrix(between))));

    float[] points = first(file, "HAnimHumanoid").node("skinCoord").floats("point");
    assertThat(points).containsExactly(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, within(1e-5f));
  }

  @Test
  void aSkinWithoutJointsIsToldAndItsMeshShown() throws IOException {
    X3dFile file =
        read(
            new GltfBuilder()
                .triangle()
                .json(ONE_NODE.formatted(",\"skin\":0", "{\"attributes\":{\"POSITION\":0}}")));

    assertThat(messages()).singleElement().asString().startsWith("skins[0]: there is no such skin");
    assertThat(all(file, "IndexedTriangleSet")).hasSize(1);
  }

  @Test
  void aJointThatTheSkinDoesNotHaveIsTold() throws IOException {
    X3dFile file =
        read(
            new GltfBuilder()
                .triangle()
                .shorts("VEC4", 3, "", 7, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0)
                .floats("VEC4", 3, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0)
                .json(
                    ONE_NODE.formatted(
                            ",\"skin\":0",
                            "{\"attributes\":{\"POSITION\":0,\"JOINTS_0\":1,\"WEIGHTS_0\":2}}")
                        + ",\"skins\":[{\"joints\":[0]}]"));

    assertThat(messages())
        .singleElement()
        .asString()
        .contains("its JOINTS_0 name joint 7, but its skin has 1");
    assertThat(all(file, "Shape")).isEmpty();
  }

  @Test
  void aJointThatWasBoundWithAMirrorIsTold() throws IOException {
    armBound.scale(-1, 1, 1);
    float[] both = matrices();
    read(
        new GltfBuilder()
            .triangle()
            .floats("MAT4", 2, both)
            .shorts("VEC4", 3, "", 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0)
            .floats("VEC4", 3, 1, 0, 0, 0, 1, 0, 0, 0, 0.25f, 0.75f, 0, 0)
            .json(
                """
                "scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"skin":0},{"children":[2]},{}],
                "skins":[{"joints":[1,2],"inverseBindMatrices":1}],
                "meshes":[{"primitives":[{"attributes":
                  {"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3}}]}]"""));

    assertThat(messages()).singleElement().asString().startsWith("skins[0]: a joint was bound");
  }
}
