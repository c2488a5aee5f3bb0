package org.selectiverenderer.models.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Arrays;
import java.util.Base64;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/** Meshes that KHR_draco_mesh_compression compresses are read. */
class GltfDracoTest extends GltfSceneTest {
  /**
   * A square of 2 by 2 with normals and red vertices, as Google's encoder (npm's draco3d 1.5.9)
   * writes it.
   */
  private static final String SQUARE =
      "RFJBQ08CAgEAAAACBAEAAQICAQMBAwAJAwAAAQkDAAECAgQAAgIDAQABAQADAwEwARADACiCiBEAAAAA/z8AAAADAQAK"
          + "AwEwGwEQAwAcggD+A/8DAAD/AQAAAAEBAAIDAUABAAkAAAAAAP8AAAAAAAAAAAAAAAAAAAAAAABADgo=";

  private static final int METHOD = 8;

  private static final String PRIMITIVE =
      """
      {"attributes":{"POSITION":0,"NORMAL":1,"COLOR_0":2},"indices":3%s,"extensions":
       {"KHR_draco_mesh_compression":{"bufferView":%d,
        "attributes":{"POSITION":0,"NORMAL":1,"COLOR_0":2}}}}""";

  private static GltfBuilder square(int vertices) {
    return new GltfBuilder()
        .empty(5126, "VEC3", vertices, "")
        .empty(5126, "VEC3", vertices, "")
        .empty(5121, "VEC4", vertices, ",\"normalized\":true")
        .empty(5123, "SCALAR", 6, "");
  }

  private X3dFile read(GltfBuilder gltf, byte[] packed, String more) throws IOException {
    int view = gltf.view(packed, 0);
    return mesh(
        gltf,
        PRIMITIVE.formatted(more, view),
        ",\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]");
  }

  private static byte[] bytes() {
    return Base64.getDecoder().decode(SQUARE);
  }

  @Test
  void positionsNormalsColoursAndTrianglesAreRead() throws IOException {
    X3dFile file = read(square(4), bytes(), "");

    assertThat(messages()).isEmpty();
    assertThat(first(file, "Coordinate").floats("point"))
        .containsExactly(0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0);
    ParsedNode triangles = first(file, "IndexedTriangleSet");
    assertThat(triangles.ints("index")).containsExactly(0, 1, 2, 2, 1, 3);
    assertThat(first(file, "Normal").floats("vector")).hasSize(12);
    assertThat(first(file, "ColorRGBA").floats("color")).startsWith(1, 0, 0, 1, 1, 0, 0, 1);
  }

  @Test
  void aStripIsTrianglesAlready() throws IOException {
    X3dFile file = read(square(4), bytes(), ",\"mode\":5");

    assertThat(messages()).isEmpty();
    assertThat(first(file, "IndexedTriangleSet").ints("index")).containsExactly(0, 1, 2, 2, 1, 3);
  }

  @Test
  void damagedDataAreToldWithTheirPlace() throws IOException {
    X3dFile file = read(square(4), Arrays.copyOf(bytes(), 40), "");

    assertThat(all(file, "Shape")).isEmpty();
    assertThat(messages())
        .containsExactly("meshes[0].primitives[0]: its Draco data are damaged; it is left out");
  }

  @Test
  void anotherNumberOfVerticesIsTold() throws IOException {
    X3dFile file = read(square(5), bytes(), "");

    assertThat(all(file, "Shape")).isEmpty();
    assertThat(messages())
        .containsExactly(
            "meshes[0].primitives[0]: accessors[0] announces another number of values than its "
                + "Draco data; it is left out");
  }

  @Test
  void morphTargetsNeedTheOrderOfTheFile() throws IOException {
    GltfBuilder gltf = square(4).floats("VEC3", 4, new float[12]);
    byte[] other = bytes();
    other[METHOD] = 1;

    X3dFile file = read(gltf, other, ",\"targets\":[{\"POSITION\":4}]");

    assertThat(all(file, "Shape")).isEmpty();
    assertThat(messages())
        .singleElement()
        .asString()
        .startsWith(
            "meshes[0].primitives[0]: it has morph targets, but Draco's method edgebreaker");
  }

  @Test
  void whatIsThereWithoutCompressionIsReadAsItIs() throws IOException {
    GltfBuilder gltf = new GltfBuilder().triangle();
    int view = gltf.view(new byte[4], 0);
    X3dFile file =
        mesh(
            gltf,
            ("{\"attributes\":{\"POSITION\":0},\"extensions\":{\"KHR_draco_mesh_compression\":"
                    + "{\"bufferView\":%d,\"attributes\":{\"POSITION\":0}}}}")
                .formatted(view),
            "");

    assertThat(messages()).isEmpty();
    assertThat(first(file, "IndexedTriangleSet").ints("index")).containsExactly(0, 1, 2);
  }
}
