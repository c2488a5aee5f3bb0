package org.selectiverenderer.models.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Base64;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.util.meshoptimizer.MeshOptimizer;
import org.selectiverenderer.x3d.read.X3dFile;

class GltfMeshTest extends GltfSceneTest {
  @ParameterizedTest
  @CsvSource({"5, '0,1,2,2,1,3'", "6, '0,1,2,0,2,3'"})
  void stripsAndFansBecomeTriangles(int mode, String triangles) throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder().floats("VEC3", 4, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0),
            "{\"mode\":%d,\"attributes\":{\"POSITION\":0}}".formatted(mode),
            "");

    assertThat(first(file, "IndexedTriangleSet").ints("index"))
        .containsExactly(Arrays.stream(triangles.split(",")).mapToInt(Integer::parseInt).toArray());
  }

  @ParameterizedTest
  @CsvSource({"1, '0,1,-1'", "2, '0,1,2,0,-1'", "3, '0,1,2,-1'"})
  void linesAreRead(int mode, String line) throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder().triangle(),
            "{\"mode\":%d,\"attributes\":{\"POSITION\":0}}".formatted(mode),
            "");

    assertThat(first(file, "IndexedLineSet").ints("coordIndex"))
        .containsExactly(Arrays.stream(line.split(",")).mapToInt(Integer::parseInt).toArray());
  }

  @Test
  void normalisedInterleavedAndSparseNumbersAreRead() throws IOException {
    GltfBuilder gltf = new GltfBuilder();
    ByteBuffer mixed = ByteBuffer.allocate(3 * 16).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < 3; i++) {
      mixed.putFloat(i).putFloat(0).putFloat(0).put((byte) 255).put((byte) 0).put((byte) 51);
      mixed.put((byte) 255);
    }
    int view = gltf.view(mixed.array(), 16);
    int places = gltf.view(new byte[] {2}, 0);
    ByteBuffer value = ByteBuffer.allocate(12).order(ByteOrder.LITTLE_ENDIAN);
    int values = gltf.view(value.putFloat(7).putFloat(8).putFloat(9).array(), 0);
    gltf.accessor(
        view,
        5126,
        "VEC3",
        3,
        ",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":%d,\"componentType\":5121},\"values\":{\"bufferView\":%d}}"
            .formatted(places, values));
    gltf.accessor(view, 5121, "VEC4", 3, ",\"byteOffset\":12,\"normalized\":true");

    X3dFile file = mesh(gltf, "{\"attributes\":{\"POSITION\":0,\"COLOR_0\":1}}", "");

    assertThat(first(file, "Coordinate").floats("point"))
        .containsExactly(0, 0, 0, 1, 0, 0, 7, 8, 9);
    assertThat(first(file, "ColorRGBA").floats("color")).startsWith(1, 0, 0.2f, 1);
  }

  @Test
  void indicesOutsideOfTheVerticesAreTold() throws IOException {
    mesh(
        new GltfBuilder().triangle().shorts("SCALAR", 3, "", 0, 1, 9),
        "{\"attributes\":{\"POSITION\":0},\"indices\":1}",
        "");

    assertThat(messages())
        .singleElement()
        .asString()
        .startsWith("meshes[0].primitives[0]: its indices name vertex 9, but it has 3");
  }

  private static byte[] packed(float... values) {
    ByteBuffer vertices = MemoryUtil.memAlloc(4 * values.length);
    ByteBuffer packed = MemoryUtil.memAlloc(1000);
    try {
      vertices.asFloatBuffer().put(values);
      int size =
          (int) MeshOptimizer.meshopt_encodeVertexBuffer(packed, vertices, values.length / 3, 12);
      byte[] bytes = new byte[size];
      packed.get(bytes);
      return bytes;
    } finally {
      MemoryUtil.memFree(vertices);
      MemoryUtil.memFree(packed);
    }
  }

  private X3dFile compressed(byte[] packed) throws IOException {
    String data = Base64.getEncoder().encodeToString(packed);
    return read(
        """
        {"asset":{"version":"2.0"},%s,
         "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
         "bufferViews":[{"buffer":1,"byteLength":36,"extensions":{"EXT_meshopt_compression":
           {"buffer":0,"byteLength":%d,"byteStride":12,"count":3,"mode":"ATTRIBUTES"}}}],
         "buffers":[{"byteLength":%d,"uri":"data:application/octet-stream;base64,%s"},
           {"byteLength":36}]}
        """
            .formatted(
                ONE_NODE.formatted("", "{\"attributes\":{\"POSITION\":0}}"),
                packed.length,
                packed.length,
                data));
  }

  @Test
  void buffersCompressedByMeshoptimizerAreRead() throws IOException {
    X3dFile file = compressed(packed(0, 0, 0, 1, 0, 0, 0, 1, 0));

    assertThat(first(file, "Coordinate").floats("point"))
        .containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
    assertThat(messages()).isEmpty();
  }

  @Test
  void damagedCompressedBuffersAreTold() throws IOException {
    compressed(new byte[] {1, 2, 3});

    assertThat(messages())
        .singleElement()
        .asString()
        .contains("EXT_meshopt_compression is damaged");
  }

  private static final String BUMPY =
      """
      ,"materials":[{"normalTexture":{"index":0}}],"textures":[{"source":0}],
       "images":[{"uri":"bumps.png"}]""";

  private static GltfBuilder withTangents() {
    return new GltfBuilder()
        .triangle()
        .floats("VEC3", 3, 0, 0, 1, 0, 0, 1, 0, 0, 1)
        .floats("VEC4", 3, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, -1)
        .floats("VEC2", 3, 0, 0, 1, 0, 0, 1);
  }

  @Test
  void tangentsServeATextureOfNormals() throws IOException {
    X3dFile file =
        mesh(
            withTangents(),
            "{\"material\":0,\"attributes\":"
                + "{\"POSITION\":0,\"NORMAL\":1,\"TANGENT\":2,\"TEXCOORD_0\":3}}",
            BUMPY);

    assertThat(first(file, "IndexedTriangleSet").node("tangent").floats("vector"))
        .containsExactly(1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, -1);
    assertThat(file.version()).isEqualTo("4.1");
    assertThat(messages()).isEmpty();
  }

  @Test
  void tangentsWithoutATextureOfNormalsAreNotNeeded() throws IOException {
    X3dFile file =
        mesh(
            withTangents(),
            "{\"attributes\":{\"POSITION\":0,\"NORMAL\":1,\"TANGENT\":2,\"TEXCOORD_0\":3}}",
            "");

    assertThat(first(file, "IndexedTriangleSet").node("tangent")).isNull();
    assertThat(file.version()).isEqualTo("4.0");
  }

  @Test
  void trianglesOutsideOfTheVerticesAreLeftOutAlone() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder().triangle().shorts("SCALAR", 6, "", 0, 1, 9, 2, 1, 0),
            "{\"attributes\":{\"POSITION\":0},\"indices\":1}",
            "");

    assertThat(first(file, "IndexedTriangleSet").ints("index")).containsExactly(2, 1, 0);
    assertThat(messages()).singleElement().asString().endsWith("the triangles there are left out");
  }

  @Test
  void aDamagedArrayLeavesOutItsShapeOnly() throws IOException {
    X3dFile file =
        read(
            new GltfBuilder()
                .triangle()
                .accessor(0, 5555, "VEC3", 3, "")
                .json(
                    ONE_NODE.formatted(
                        "",
                        "{\"attributes\":{\"POSITION\":0,\"COLOR_0\":1}},"
                            + "{\"attributes\":{\"POSITION\":0}}")));

    assertThat(all(file, "Shape")).hasSize(1);
    assertThat(messages()).singleElement().asString().contains("componentType is none of glTF's");
  }

  @Test
  void onlyWhatNeedsABufferViewOutsideOfItsBufferIsLeftOut() throws IOException {
    String gltf =
        new GltfBuilder()
            .triangle()
            .triangle()
            .json(
                ONE_NODE.formatted(
                    "", "{\"attributes\":{\"POSITION\":0}},{\"attributes\":{\"POSITION\":1}}"))
            .replace("\"byteOffset\":36", "\"byteOffset\":9223372036854775807");

    X3dFile file = read(gltf);

    assertThat(all(file, "Shape")).hasSize(1);
    assertThat(messages())
        .containsExactly(
            "meshes[0].primitives[1]: bufferViews[1] lies outside of its buffer; the file is"
                + " damaged or cut off; it is left out");
  }

  @Test
  void onlyWhatNeedsAnAccessorOutsideOfItsBufferViewIsLeftOut() throws IOException {
    GltfBuilder gltf = new GltfBuilder().triangle();
    gltf.accessor(0, 5126, "VEC3", 4, "");

    X3dFile file =
        mesh(
            gltf,
            "{\"attributes\":{\"POSITION\":0,\"NORMAL\":1}},{\"attributes\":{\"POSITION\":1}}",
            "");

    assertThat(all(file, "Shape")).hasSize(1);
    assertThat(messages()).singleElement().asString().startsWith("meshes[0].primitives[1]: ");
  }
}
