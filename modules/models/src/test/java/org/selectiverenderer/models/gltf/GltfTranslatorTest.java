package org.selectiverenderer.models.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.util.meshoptimizer.MeshOptimizer;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.NodeTraversal;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;

class GltfTranslatorTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();

  private static final String ONE_NODE =
      "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0%s}],"
          + "\"meshes\":[{\"primitives\":[%s]}]";

  @TempDir Path folder;

  private final ProblemCollector problems = new ProblemCollector();

  private X3dFile read(String json) throws IOException {
    Path file = Files.writeString(folder.resolve("model.gltf"), json);
    return new X3dReader(CATALOGUE).read(file, problems);
  }

  private X3dFile mesh(GltfBuilder gltf, String primitive, String more) throws IOException {
    return read(gltf.json(ONE_NODE.formatted("", primitive) + more));
  }

  private static ParsedNode first(X3dFile file, String type) {
    List<ParsedNode> found = new ArrayList<>();
    NodeTraversal.visit(
        file.allNodes(),
        node -> {
          if (node.type().name().equals(type)) {
            found.add(node);
          }
        });
    assertThat(found).as(type).isNotEmpty();
    return found.get(0);
  }

  private List<String> messages() {
    return problems.list().stream().map(Problem::message).toList();
  }

  @Test
  void trianglesAreReadWithTheNodesThatPlaceThem() throws IOException {
    String gltf =
        new GltfBuilder()
            .triangle()
            .json(
                ONE_NODE.formatted(
                    ",\"name\":\"my chair\",\"translation\":[5,0,0],\"scale\":[2,2,2]",
                    "{\"attributes\":{\"POSITION\":0}}"));

    X3dFile file = read(gltf);

    ParsedNode chair = first(file, "Transform");
    assertThat(chair.floats("translation")).containsExactly(5, 0, 0);
    assertThat(chair.floats("scale")).containsExactly(2, 2, 2);
    assertThat(first(file, "MetadataString").strings("value")).containsExactly("my chair");
    ParsedNode triangles = first(file, "IndexedTriangleSet");
    assertThat(triangles.ints("index")).containsExactly(0, 1, 2);
    assertThat(triangles.bool("normalPerVertex")).isFalse();
    assertThat(messages()).isEmpty();
  }

  @Test
  void binaryGltfIsReadWhateverItsNameEndsIn() throws IOException {
    byte[] glb =
        new GltfBuilder()
            .triangle()
            .binary(ONE_NODE.formatted("", "{\"attributes\":{\"POSITION\":0}}"));
    Path path = Files.write(folder.resolve("model.bin"), glb);

    X3dFile file = new X3dReader(CATALOGUE).read(path, problems);

    assertThat(first(file, "Coordinate").floats("point"))
        .containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
    assertThat(messages()).isEmpty();
  }

  @Test
  void aMatrixBecomesTranslationRotationAndScale() throws IOException {
    // a quarter turn about y, twice as large along x
    String matrix = ",\"matrix\":[0,0,-2,0,0,1,0,0,1,0,0,0,7,8,9,1]";
    X3dFile file =
        read(
            new GltfBuilder()
                .triangle()
                .json(ONE_NODE.formatted(matrix, "{\"attributes\":{\"POSITION\":0}}")));

    ParsedNode transform = first(file, "Transform");
    assertThat(transform.floats("translation")).containsExactly(7, 8, 9);
    assertThat(transform.floats("scale")).containsExactly(2, 1, 1);
    assertThat(transform.floats("rotation")[1]).isEqualTo(1);
    assertThat(transform.floats("rotation")[3]).isCloseTo((float) (Math.PI / 2), within(1e-5f));
  }

  @Test
  void aShearIsTold() throws IOException {
    String matrix = ",\"matrix\":[1,0,0,0,1,1,0,0,0,0,1,0,0,0,0,1]";
    read(
        new GltfBuilder()
            .triangle()
            .json(ONE_NODE.formatted(matrix, "{\"attributes\":{\"POSITION\":0}}")));

    assertThat(messages()).singleElement().asString().startsWith("nodes[0].matrix: it shears");
  }

  @Test
  void materialsBecomePhysicalMaterials() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder().triangle(),
            "{\"attributes\":{\"POSITION\":0},\"material\":0}",
            """
            ,"materials":[{"name":"brass","doubleSided":true,"alphaMode":"MASK","alphaCutoff":0.25,
             "emissiveFactor":[0.5,0,0],
             "pbrMetallicRoughness":{"baseColorFactor":[0.25,0.5,0.75,0.5],"metallicFactor":0.75}}]
            """);

    ParsedNode material = first(file, "PhysicalMaterial");
    assertThat(material.floats("baseColor")).containsExactly(0.25f, 0.5f, 0.75f);
    assertThat(material.number("metallic")).isEqualTo(0.75f);
    assertThat(material.number("roughness")).isEqualTo(1);
    assertThat(material.number("transparency")).isEqualTo(0.5f);
    assertThat(material.floats("emissiveColor")).containsExactly(0.5f, 0, 0);
    ParsedNode appearance = first(file, "Appearance");
    assertThat(appearance.string("alphaMode")).isEqualTo("MASK");
    assertThat(appearance.number("alphaCutoff")).isEqualTo(0.25f);
    assertThat(first(file, "IndexedTriangleSet").bool("solid")).isFalse();
  }

  @Test
  void anUnlitMaterialHasNoLight() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder().triangle(),
            "{\"attributes\":{\"POSITION\":0},\"material\":0}",
            ",\"materials\":[{\"extensions\":{\"KHR_materials_unlit\":{}}}]");

    assertThat(first(file, "UnlitMaterial").floats("emissiveColor")).containsExactly(1, 1, 1);
    assertThat(messages()).isEmpty();
  }

  @Test
  void anUnknownExtensionOfAMaterialIsTold() throws IOException {
    mesh(
        new GltfBuilder().triangle(),
        "{\"attributes\":{\"POSITION\":0},\"material\":0}",
        ",\"materials\":[{\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{}}}]");

    assertThat(messages())
        .containsExactly(
            "materials[0]: X3D has nothing like the extension KHR_materials_pbrSpecularGlossiness,"
                + " which is left out");
  }

  @Test
  void picturesInTheFileBecomeDataUrlsAndCoordinatesAreTurnedUpright() throws IOException {
    GltfBuilder gltf = new GltfBuilder().triangle().floats("VEC2", 3, 0, 0, 1, 0, 0, 1);
    int picture = gltf.view(new byte[] {(byte) 0x89, 'P', 'N', 'G'}, 0);

    X3dFile file =
        mesh(
            gltf,
            "{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"material\":0}",
            """
            ,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
             "textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071}],
             "images":[{"bufferView":%d,"mimeType":"image/png"}]"""
                .formatted(picture));

    ParsedNode texture = first(file, "ImageTexture");
    assertThat(texture.strings("url")).containsExactly("data:image/png;base64,iVBORw==");
    assertThat(texture.bool("repeatS")).isFalse();
    assertThat(texture.bool("repeatT")).isTrue();
    assertThat(first(file, "TextureCoordinate").floats("point")).containsExactly(0, 1, 1, 1, 0, 0);
  }

  @Test
  void texturesOfSeveralSetsAndTransformsAreTiedByNames() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder()
                .triangle()
                .floats("VEC2", 3, 0, 0, 1, 0, 0, 1)
                .floats("VEC2", 3, 0, 0, 0.5f, 0, 0, 0.5f),
            "{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1,\"TEXCOORD_1\":2},\"material\":0}",
            """
            ,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":
              {"KHR_texture_transform":{"scale":[0.5,0.5],"offset":[0.5,0]}}}},
              "occlusionTexture":{"index":0,"texCoord":1}}],
             "textures":[{"source":0}],"images":[{"uri":"wood.png"}]""");

    ParsedNode material = first(file, "PhysicalMaterial");
    assertThat(material.string("baseTextureMapping")).isEqualTo("channel0");
    assertThat(material.string("occlusionTextureMapping")).isEqualTo("channel1");
    assertThat(first(file, "MultiTextureCoordinate").nodes("texCoord")).hasSize(2);
    ParsedNode transform = first(file, "TextureTransform");
    assertThat(transform.string("mapping")).isEqualTo("channel0");
    // (u, v) = (0, 0) is shown at (0.5, 0) in glTF: (s, t) = (0, 1) at (0.5, 1) in X3D
    assertThat(transform.floats("translation")).containsExactly(1, 1);
    assertThat(first(file, "ImageTexture").strings("url")).containsExactly("wood.png");
  }

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
  void camerasAndLightsHaveTheirNodesPlace() throws IOException {
    X3dFile file =
        read(
            new GltfBuilder()
                .triangle()
                .json(
                    """
                    "scenes":[{"nodes":[0,1]}],"nodes":[{"name":"door","camera":0},
                     {"extensions":{"KHR_lights_punctual":{"light":0}}}],
                    "cameras":[{"type":"perspective","perspective":{"yfov":1,"aspectRatio":0.5}}],
                    "extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","intensity":20,
                     "spot":{"innerConeAngle":0.25,"outerConeAngle":0.5}}]}}"""));

    ParsedNode camera = first(file, "Viewpoint");
    assertThat(camera.string("description")).isEqualTo("door");
    assertThat(camera.floats("position")).containsExactly(0, 0, 0);
    assertThat(camera.number("fieldOfView"))
        .isEqualTo((float) (2 * Math.atan(Math.tan(0.5) * 0.5)));
    ParsedNode light = first(file, "SpotLight");
    assertThat(light.number("cutOffAngle")).isEqualTo(0.5f);
    assertThat(light.number("beamWidth")).isEqualTo(0.25f);
    assertThat(light.floats("attenuation")).containsExactly(0, 0, 1);
  }

  @Test
  void animationsBecomeInterpolatorsWithRoutes() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder()
                .triangle()
                .floats("SCALAR", 2, 0, 4)
                .floats("VEC3", 2, 0, 0, 0, 1, 2, 3),
            "{\"attributes\":{\"POSITION\":0}}",
            """
            ,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],
             "samplers":[{"input":1,"output":2,"interpolation":"STEP"}]}]""");

    assertThat(first(file, "TimeSensor").bool("loop")).isTrue();
    ParsedNode interpolator = first(file, "PositionInterpolator");
    assertThat(interpolator.floats("key")).containsExactly(0, 1, 1);
    assertThat(interpolator.floats("keyValue")).containsExactly(0, 0, 0, 0, 0, 0, 1, 2, 3);
    assertThat(file.routes()).hasSize(2);
  }

  @Test
  void animatedMorphTargetsMoveTheCoordinates() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder()
                .triangle()
                .floats("VEC3", 3, 0, 0, 1, 0, 0, 1, 0, 0, 1)
                .floats("SCALAR", 2, 0, 1)
                .floats("SCALAR", 2, 0, 2),
            "{\"attributes\":{\"POSITION\":0},\"targets\":[{\"POSITION\":1}]}",
            """
            ,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}],
             "samplers":[{"input":2,"output":3}]}]""");

    assertThat(first(file, "CoordinateInterpolator").floats("keyValue"))
        .containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2, 1, 0, 2, 0, 1, 2);
    assertThat(messages()).isEmpty();
  }

  @Test
  void aMissingBufferIsNamed() throws IOException {
    X3dFile file =
        read(
            new GltfBuilder()
                .triangle()
                .json(
                    ONE_NODE.formatted("", "{\"attributes\":{\"POSITION\":0}}"),
                    ",\"uri\":\"gone.bin\""));

    assertThat(file.nodes()).isEmpty();
    assertThat(messages()).containsExactly("buffers[0].uri 'gone.bin' is missing; nothing is read");
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

  @Test
  void namesMayHaveWhatXmlForbids() throws IOException {
    X3dFile file =
        read(
            new GltfBuilder()
                .triangle()
                .json(
                    ONE_NODE.formatted(
                        ",\"name\":\"\\u0000<&\\\"'>\\u001b\"",
                        "{\"attributes\":{\"POSITION\":0}}")));

    assertThat(messages()).isEmpty();
    assertThat(first(file, "MetadataString").strings("value"))
        .containsExactly("\ufffd<&\"'>\ufffd");
  }

  @Test
  void referencesToNothingAreTold() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder().triangle(),
            "{\"attributes\":{\"POSITION\":0},\"material\":0}",
            """
            ,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":9,"texCoord":7}}}],
             "animations":[{"channels":[{"sampler":5,"target":{"node":0,"path":"rotation"}}]}]""");

    assertThat(first(file, "IndexedTriangleSet").ints("index")).hasSize(3);
    assertThat(messages())
        .anyMatch(message -> message.contains("TEXCOORD_7, which it lacks"))
        .anyMatch(message -> message.contains("the texture has no picture"))
        .anyMatch(message -> message.startsWith("animations[0].channels[0]"));
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

  @Test
  void aModelOfGltf1IsRefused() throws IOException {
    read("{\"asset\":{\"version\":\"1.0\"},\"nodes\":{}}");

    assertThat(messages()).singleElement().asString().contains("glTF 1.0");
  }

  @Test
  void skinsAreTold() throws IOException {
    read(
        new GltfBuilder()
            .triangle()
            .json(ONE_NODE.formatted(",\"skin\":0", "{\"attributes\":{\"POSITION\":0}}")));

    assertThat(messages()).singleElement().asString().startsWith("nodes[0].skin: skins are not");
  }
}
