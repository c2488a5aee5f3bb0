package org.selectiverenderer.models.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.ReadLimits;

class GltfTranslatorTest extends GltfSceneTest {
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
    assertThat(first(file, "Viewpoint").bool("viewAll")).isTrue(); // as there is no camera
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

  @Test
  void aModelOfGltf1IsReadByAssimp() throws IOException {
    X3dFile file =
        read(
            """
            {"asset":{"version":"1.0"},"scene":"s","scenes":{"s":{"nodes":["n"]}},
             "nodes":{"n":{"meshes":["m"],"name":"leaf"}},
             "meshes":{"m":{"primitives":[{"attributes":{"POSITION":"a"},"mode":4}]}},
             "accessors":{"a":{"bufferView":"v","byteOffset":0,"byteStride":12,
               "componentType":5126,"count":3,"type":"VEC3"}},
             "bufferViews":{"v":{"buffer":"b","byteOffset":0,"byteLength":36}},
             "buffers":{"b":{"byteLength":36,"type":"arraybuffer",
               "uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}}
            """);

    assertThat(messages()).isEmpty();
    assertThat(all(file, "Coordinate")).hasSize(1);
  }

  @Test
  void aDamagedModelOfGltf1IsTold() throws IOException {
    read("{\"asset\":{\"version\":\"1.0\"},\"nodes\":{},\"scene\":7}");

    assertThat(messages()).hasSizeLessThanOrEqualTo(1);
  }

  @Test
  void aModelThatBecomesTooLongATextIsRefused() throws IOException {
    StringBuilder nodes = new StringBuilder("{}");
    StringBuilder roots = new StringBuilder("0");
    for (int i = 1; i < 5000; i++) {
      nodes.append(",{}"); // each becomes a Transform
      roots.append(',').append(i);
    }
    String gltf =
        "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[%s]}],\"nodes\":[%s]}"
            .formatted(roots, nodes);
    Path path = Files.writeString(folder.resolve("model.gltf"), gltf);

    new X3dReader(CATALOGUE, new ReadLimits(100_000, 1000, 100, 10_000)).read(path, problems);

    assertThat(messages())
        .singleElement()
        .asString()
        .contains("it becomes an X3D text of more than 0.1 MB, which is the limit");
  }

  private X3dFile lamps(int candela) throws IOException {
    return read(
        new GltfBuilder()
            .triangle()
            .json(
                """
                "scenes":[{"nodes":[0,1,2]}],"nodes":[
                 {"extensions":{"KHR_lights_punctual":{"light":0}}},
                 {"extensions":{"KHR_lights_punctual":{"light":1}}},
                 {"extensions":{"KHR_lights_punctual":{"light":2}}}],
                "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","intensity":%d},
                 {"type":"spot","intensity":6.83,"spot":{}},
                 {"type":"directional","intensity":2000}]}}"""
                    .formatted(candela)));
  }

  @Test
  void lampsInCandelaAreDimmedAlikeWhichIsTold() throws IOException {
    X3dFile file = lamps(27320);

    assertThat(first(file, "PointLight").number("intensity")).isEqualTo(40);
    assertThat(first(file, "SpotLight").number("intensity")).isEqualTo(0.01f);
    assertThat(first(file, "DirectionalLight").number("intensity")).isEqualTo(2000);
    assertThat(messages()).singleElement().asString().startsWith("nodes[0]: ").contains("683");
  }

  @Test
  void lampsThatArePossiblyNotInCandelaAreAsBrightAsTheyAre() throws IOException {
    X3dFile file = lamps(1000);

    assertThat(first(file, "PointLight").number("intensity")).isEqualTo(1000);
    assertThat(first(file, "SpotLight").number("intensity")).isEqualTo(6.83f);
    assertThat(messages()).isEmpty();
  }

  /** X3D measures from a light in the light's own coordinates (X3D 4.0, 17.2.1.4). */
  @Test
  void theScaleOfNodesDoesNotChangeHowLightsFallOff() throws IOException {
    X3dFile file =
        read(
            new GltfBuilder()
                .json(
                    """
                    "scenes":[{"nodes":[0]}],"nodes":[{"scale":[2,2,2],"children":[1]},
                     {"scale":[5,5,5],"extensions":{"KHR_lights_punctual":{"light":0}}}],
                    "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","range":40}]}}"""));

    ParsedNode light = first(file, "PointLight");
    assertThat(light.floats("attenuation")).containsExactly(0, 0, 100);
    assertThat(light.number("radius")).isEqualTo(4);
  }
}
