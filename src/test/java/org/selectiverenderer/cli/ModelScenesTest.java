package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Models of other programs, given to the commands that read scenes. */
class ModelScenesTest extends CommandTestCase {
  private static final byte[] PICTURE = {(byte) 0x89, 'P', 'N', 'G'};

  private static final String JSON =
      """
      {"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"name":"chair","mesh":0}],
       "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
       "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
       "textures":[{"source":0}],"images":[{"bufferView":2,"mimeType":"image/png"}],
       "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
        {"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}],
       "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24},
        {"buffer":0,"byteOffset":60,"byteLength":4}],
       "buffers":[{"byteLength":64%s}]}
      """;

  @TempDir Path folder;

  private static byte[] numbers() {
    ByteBuffer data = ByteBuffer.allocate(64).order(ByteOrder.LITTLE_ENDIAN);
    for (float value : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1}) {
      data.putFloat(value);
    }
    return data.put(PICTURE).array();
  }

  private Path glb() throws IOException {
    String text = JSON.formatted("");
    byte[] json = (text + " ".repeat(-text.length() & 3)).getBytes(StandardCharsets.UTF_8);
    ByteBuffer glb = ByteBuffer.allocate(28 + json.length + 64).order(ByteOrder.LITTLE_ENDIAN);
    glb.putInt(0x46546C67).putInt(2).putInt(glb.capacity());
    glb.putInt(json.length).putInt(0x4E4F534A).put(json);
    glb.putInt(64).putInt(0x4E4942).put(numbers());
    return Files.write(folder.resolve("chair.glb"), glb.array());
  }

  @ParameterizedTest
  @ValueSource(strings = {"chair.glb", "chair.gltf", "chair.obj", "chair.stl", "chair.ply"})
  void aModelIsCountedWhereAnInlineNamesIt(String name) throws IOException {
    glb();
    Files.writeString(folder.resolve("chair.gltf"), JSON.formatted(",\"uri\":\"chair.bin\""));
    Files.write(folder.resolve("chair.bin"), numbers());
    Files.writeString(folder.resolve("chair.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Files.writeString(
        folder.resolve("chair.stl"),
        """
        solid chair
        facet normal 0 0 1
        outer loop
        vertex 0 0 0
        vertex 1 0 0
        vertex 0 1 0
        endloop
        endfacet
        endsolid chair
        """);
    Files.writeString(
        folder.resolve("chair.ply"),
        """
        ply
        format ascii 1.0
        element vertex 3
        property float x
        property float y
        property float z
        element face 1
        property list uchar int vertex_indices
        end_header
        0 0 0
        1 0 0
        0 1 0
        3 0 1 2
        """);
    Path scene =
        Files.writeString(
            folder.resolve("room.x3d"),
            "<X3D version='4.0' profile='Full'><Scene><Inline url='\"%s\"'/></Scene></X3D>"
                .formatted(name));

    assertThat(execute("polygons", scene.toString())).as(messages()).isZero();

    assertThat(printed())
        .containsPattern("as loaded +1 ")
        .contains("1 polygons; no object is enriched");
  }

  @Test
  void aModelIsValidatedWithoutFindings() throws IOException {
    assertThat(execute("validate", glb().toString())).as(messages()).isBetween(0, 1);
    assertThat(printed() + messages()).doesNotContain("SR0");
  }

  @Test
  void theFileThatAModelLacksIsNamed() throws IOException {
    Path model =
        Files.writeString(folder.resolve("chair.gltf"), JSON.formatted(",\"uri\":\"chair.bin\""));

    assertThat(execute("validate", model.toString())).isEqualTo(1);

    assertThat(printed()).contains("buffers[0].uri 'chair.bin' is missing; nothing is read");
  }

  @Test
  void convertWritesThePicturesOfAModelBesideTheScene() throws IOException {
    Path output = folder.resolve("converted.x3d");

    assertThat(execute("convert", glb().toString(), output.toString())).as(messages()).isZero();

    assertThat(output)
        .content()
        .contains("version='4.0'", "<Transform DEF='chair'", "url='\"converted-1.png\"'");
    assertThat(folder.resolve("converted-1.png")).hasBinaryContent(PICTURE);
    assertThat(execute("convert", folder.resolve("chair.glb").toString(), output.toString()))
        .as("its own pictures may be there")
        .isZero();
  }

  @Test
  void anObjectOfAModelGetsVersionsInAnotherFile() throws IOException {
    String model = glb().toString();
    assertThat(execute("versions", model, "--object", "chair", "--polygons", "1")).isEqualTo(1);
    assertThat(messages())
        .contains("but versions are written as X3D XML; name an X3D file with --output");
    Path output = folder.resolve("versions.x3d");
    assertThat(
            execute(
                "versions",
                model,
                "--object",
                "chair",
                "--polygons",
                "1",
                "--output",
                output.toString()))
        .as(messages())
        .isZero();
    assertThat(output).content().contains("<Switch", "chair_v1.x3d", "chair_v2.x3d");
  }

  @Test
  void convertOverwritesNoOtherPicture() throws IOException {
    Path output = folder.resolve("converted.x3d");
    Path picture = Files.writeString(folder.resolve("converted-1.png"), "mine");

    assertThat(execute("convert", glb().toString(), output.toString())).isEqualTo(2);

    assertThat(picture).hasContent("mine");
    assertThat(output).doesNotExist();
  }

  @Test
  void convertKeepsThePicturesInsideIfAsked() throws IOException {
    Path output = folder.resolve("converted.x3d");

    assertThat(execute("convert", "--embed", glb().toString(), output.toString())).isZero();

    assertThat(output).content().contains("data:image/png;base64,iVBORw==");
    assertThat(folder.resolve("converted-1.png")).doesNotExist();
  }
}
