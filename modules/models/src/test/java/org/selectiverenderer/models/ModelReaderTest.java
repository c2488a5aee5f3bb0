package org.selectiverenderer.models;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.models.importer.ImportLimits;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

class ModelReaderTest {
  private static final String TRIANGLE =
      "<IndexedFaceSet coordIndex='0 1 2 -1'><Coordinate point='0 0 0 1 0 0 0 1 0'/>"
          + "</IndexedFaceSet>";

  /** One for all tests, so that its process is started once. */
  private static final ModelReader reader = new ModelReader(NodeCatalogue.load());

  @TempDir Path folder;

  private final ProblemCollector problems = new ProblemCollector();

  @AfterAll
  static void close() {
    reader.close();
  }

  private Path write(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private Optional<Model> readScene(String content) throws IOException {
    return reader.read(write("scenes/model.x3d", scene(content)), problems);
  }

  private static String scene(String content) {
    return "<X3D profile='Immersive' version='3.3'><Scene>" + content + "</Scene></X3D>";
  }

  private List<String> messages() {
    return problems.list().stream().map(Problem::message).toList();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<Box/>",
        "<Sphere/>",
        "<Cylinder/>",
        "<Cone/>",
        "<Extrusion/>",
        "<ElevationGrid xDimension='2' zDimension='2' height='0 1 0 1'/>",
        "<TriangleSet><Coordinate point='0 0 0 1 0 0 0 1 0'/></TriangleSet>",
        "<Text string='\"A\"'/>",
        TRIANGLE
      })
  void geometryOfAnyKindHasFaces(String geometry) throws IOException {
    Model model = readScene("<Shape>" + geometry + "</Shape>").orElseThrow();

    assertThat(model.polygons()).isPositive();
    assertThat(model.parts().get(0).mesh().normals()).isNotNull();
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void transformationsAreApplied() throws IOException {
    Model model =
        readScene(
                "<Transform translation='10 0 0'><Transform scale='2 3 4' rotation='0 0 1 1.5708'>"
                    + "<Shape>"
                    + TRIANGLE
                    + "</Shape></Transform></Transform>")
            .orElseThrow();

    Mesh mesh = model.parts().get(0).mesh();
    assertThat(mesh.bounds()[0]).isCloseTo(7, within(1e-3f));
    assertThat(mesh.bounds()[3]).isCloseTo(10, within(1e-3f));
    assertThat(mesh.bounds()[4]).isCloseTo(2, within(1e-3f));
    assertThat(mesh.normals()[2]).isCloseTo(1, within(1e-5f));
  }

  @Test
  void aMirrorKeepsTheOutsideOut() throws IOException {
    Model model =
        readScene("<Transform scale='-1 1 1'><Shape><Box/></Shape></Transform>").orElseThrow();

    Mesh mesh = model.parts().get(0).mesh();
    for (int i = 0; i < mesh.indices().length; i += 3) {
      double[] face = MeshWriter.FaceNormal.of(mesh.positions(), mesh.indices(), i);
      int at = 3 * mesh.indices()[i];
      double outwards = 0;
      for (int axis = 0; axis < 3; axis++) {
        outwards += face[axis] * mesh.positions()[at + axis];
        assertThat(mesh.normals()[at + axis]).isCloseTo((float) face[axis], within(1e-5f));
      }
      assertThat(outwards).isCloseTo(1, within(1e-6));
    }
  }

  @Test
  void whatABrowserShowsFirstIsTheModel() throws IOException {
    Model model =
        readScene(
                "<Switch whichChoice='1'><Shape><Sphere/></Shape><Shape><Box/></Shape></Switch>"
                    + "<LOD range='5'><Shape><Box/></Shape><Shape><Sphere/></Shape></LOD>"
                    + "<Collision><Shape containerField='proxy'><Sphere/></Shape>"
                    + "<Shape><Box/></Shape></Collision>")
            .orElseThrow();

    assertThat(model.polygons()).isEqualTo(36);
  }

  @Test
  void inlinesOfTheSceneAndItsNeighbourFolderAreFollowed() throws IOException {
    write("inlineNodes/box.x3d", scene("<Shape><Box/></Shape>"));
    write("scenes/parts/more.x3d", scene("<Inline url='\"../../inlineNodes/box.x3d\"'/>"));

    Model model = readScene("<Inline url='\"parts/more.x3d\"'/>").orElseThrow();

    assertThat(model.polygons()).isEqualTo(12);
  }

  @Test
  void anInlineInOtherUnitsIsConverted() throws IOException {
    write(
        "scenes/mm.x3d",
        "<X3D version='3.3'><head><unit category='length' name='mm' conversionFactor='0.001'/>"
            + "</head><Scene><Shape><Box size='500 500 500'/></Shape></Scene></X3D>");

    Model model = readScene("<Inline url='\"mm.x3d\"'/>").orElseThrow();

    assertThat(model.parts().get(0).mesh().bounds()[3]).isCloseTo(0.25f, within(1e-6f));
  }

  @ParameterizedTest
  @ValueSource(strings = {"../outside.x3d", "http://example.org/a.x3d", "missing.x3d"})
  void otherInlinesAreLeftOut(String url) throws IOException {
    write("outside.x3d", scene("<Shape><Box/></Shape>"));

    assertThat(readScene("<Inline url='\"" + url + "\"'/>")).isEmpty();
    assertThat(messages()).anyMatch(message -> message.contains(url));
  }

  @Test
  void aFileThatInlinesItselfEnds() throws IOException {
    Model model = readScene("<Shape><Box/></Shape><Inline url='\"model.x3d\"'/>").orElseThrow();

    assertThat(model.polygons()).isEqualTo(24);
    assertThat(messages()).anyMatch(message -> message.contains("a file that contains it"));
  }

  @Test
  void textureCoordinatesCountOnlyUnderATexture() throws IOException {
    Model model =
        readScene(
                "<Shape><Appearance><Material/></Appearance><Box/></Shape><Shape><Appearance>"
                    + "<ImageTexture url='\"wood.png\"'/></Appearance><Box/></Shape>")
            .orElseThrow();

    assertThat(model.parts().get(0).mesh().texCoords()).isNull();
    assertThat(model.parts().get(1).mesh().texCoords()).isNotNull();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "<Shape/>",
        "<Shape><IndexedFaceSet/></Shape>",
        "<Shape><PointSet><Coordinate point='0 0 0'/></PointSet></Shape>",
        "<Shape><IndexedFaceSet coordIndex='0 1 2 -1'><Coordinate point='0 0 0 1 1 1 2 2 2'/>"
            + "</IndexedFaceSet></Shape>"
      })
  void aModelWithoutFacesIsSaidToHaveNone(String content) throws IOException {
    assertThat(readScene(content)).isEmpty();
    assertThat(problems.any()).isTrue();
    assertThat(problems.list().get(problems.list().size() - 1).toString())
        .contains("model.x3d")
        .contains("has no faces");
  }

  @Test
  void numbersThatAreNoneAreReportedAndDoNotStopTheRest() throws IOException {
    Model model =
        readScene(
                "<Shape><IndexedFaceSet coordIndex='0 1 2 -1 1 2 3 -1'>"
                    + "<Coordinate point='0 0 0 1 0 0 0 1 0 NaN 1 0'/></IndexedFaceSet></Shape>")
            .orElseThrow();

    assertThat(model.polygons()).isBetween(1, 2);
    assertThat(messages()).anyMatch(message -> message.contains("NaN"));
  }

  @Test
  void aShapeThatNestedUsesMultiplyEndsWithALine() throws IOException {
    StringBuilder groups = new StringBuilder("<Group DEF='g0'><Shape><Sphere/></Shape></Group>");
    for (int i = 0; i < 30; i++) {
      groups
          .insert(0, "<Group DEF='g" + (i + 1) + "'>")
          .append("<Group USE='g" + i + "'/></Group>");
    }
    Path file = write("scenes/model.x3d", scene(groups.toString()));
    ImportLimits limits = new ImportLimits(1, 1, 1, 1 << 20, Duration.ZERO, Duration.ZERO, 0, 0);

    ModelReader limited =
        new ModelReader(NodeCatalogue.load(), ContentAccessPolicy.none(), Optional.empty(), limits);
    assertThat(limited.read(file, problems)).isEmpty();
    assertThat(messages())
        .containsExactly(
            "the file has more than 1 MiB of vertices, which is the limit; it is not read");
  }

  @Test
  void objIsReadWithItsMaterial() throws IOException {
    write("a/m.mtl", "newmtl red\nKd 1 0.5 0\nNs 64\nd 0.25\nmap_Kd wood.png\n");
    Path file =
        write(
            "a/quad.OBJ",
            "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                + "usemtl red\nf 1/1 2/2 3/3 4/4\n");

    Model model = reader.read(file, problems).orElseThrow();

    assertThat(model.polygons()).isEqualTo(2);
    NodeView appearance = model.parts().get(0).appearance();
    assertThat(appearance.node("material").floats("diffuseColor")).containsExactly(1, 0.5f, 0);
    assertThat(appearance.node("material").number("transparency")).isEqualTo(0.75f);
    assertThat(appearance.node("texture").strings("url")).containsExactly("wood.png");
    assertThat(model.parts().get(0).mesh().texCoords()).isNotNull();
  }

  @Test
  void plyIsReadWithItsColours() throws IOException {
    Path file =
        write(
            "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                + "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                + "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                + "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n");

    Model model = reader.read(file, problems).orElseThrow();

    assertThat(model.polygons()).isEqualTo(1);
    assertThat(model.parts().get(0).mesh().colors()).hasSize(12);
    // A highlight over the entire surface would make all colours white.
    assertThat(material(model).floats("specularColor")).containsExactly(0, 0, 0);
  }

  private static NodeView material(Model model) {
    return model.parts().get(0).appearance().node("material");
  }

  @Test
  void anObjWithASpecularColourButNoExponentHasNoHighlightOverTheEntireSurface()
      throws IOException {
    write("m.mtl", "newmtl red\nKd 1 0 0\nKs 1 1 1\nNs 0\n");
    Path file = write("a.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");

    Model model = reader.read(file, problems).orElseThrow();

    assertThat(material(model).floats("diffuseColor")).containsExactly(1, 0, 0);
    assertThat(material(model).floats("specularColor")).containsExactly(0, 0, 0);
  }

  @Test
  void aFaceWithoutCornersBesideALargerOneIsLeftOut() throws IOException {
    Path file =
        write(
            "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                + "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
                + "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0\n4 0 1 2 3\n");

    assertThat(reader.read(file, problems).orElseThrow().polygons()).isEqualTo(2);
  }

  @Test
  void stlIsWeldedAndSmoothed() throws IOException {
    StringBuilder text = new StringBuilder("solid cube\n");
    for (String corners : new String[] {"0 0 0,1 0 0,1 1 0", "0 0 0,1 1 0,0 1 0"}) {
      text.append("facet normal 0 0 1\nouter loop\n");
      for (String corner : corners.split(",")) {
        text.append("vertex ").append(corner).append('\n');
      }
      text.append("endloop\nendfacet\n");
    }
    Path file = write("größe.stl", text.append("endsolid cube\n").toString());

    Model model = reader.read(file, problems).orElseThrow();

    assertThat(model.polygons()).isEqualTo(2);
    assertThat(model.parts().get(0).mesh().vertexCount()).isEqualTo(4);
    assertThat(material(model).floats("diffuseColor")).containsExactly(0.8f, 0.8f, 0.8f);
    assertThat(material(model).floats("specularColor")).containsExactly(0, 0, 0);
  }

  @Test
  void gltfIsReadWithItsTransformation() throws IOException {
    ByteBuffer data = ByteBuffer.allocate(42).order(ByteOrder.LITTLE_ENDIAN);
    for (float value : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}) {
      data.putFloat(value);
    }
    for (int index = 0; index < 3; index++) {
      data.putShort((short) index);
    }
    Path file =
        write(
            "t.gltf",
            """
            {"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
             "nodes":[{"mesh":0,"translation":[5,0,0]}],
             "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
             "materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.2,0.4,0.6,1]}}],
             "accessors":[
              {"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
              {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
             "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
             "buffers":[{"byteLength":42,"uri":"data:application/octet-stream;base64,%s"}]}
            """
                .formatted(Base64.getEncoder().encodeToString(data.array())));

    Model model = reader.read(file, problems).orElseThrow();

    assertThat(model.parts().get(0).mesh().bounds()).startsWith(5, 0, 0);
    assertThat(model.parts().get(0).appearance().node("material").floats("baseColor"))
        .containsExactly(0.2f, 0.4f, 0.6f);
  }

  @ParameterizedTest
  @CsvSource({"a.obj", "a.ply", "a.stl", "a.gltf", "a.glb"})
  void whatIsNoModelIsAnErrorThatNamesTheFile(String name) throws IOException {
    Path file = folder.resolve(name);
    Files.write(file, "no model at all\n".getBytes(StandardCharsets.UTF_8));

    assertThat(reader.read(file, problems)).isEmpty();
    assertThat(problems.list().toString()).contains(name);
  }

  @Test
  void aFileThatIsNotThereIsAnErrorThatNamesIt() {
    for (String name : new String[] {"gone.obj", "gone.x3d"}) {
      assertThatExceptionOfType(IOException.class)
          .isThrownBy(() -> reader.read(folder.resolve(name), problems))
          .withMessageContaining(name);
    }
  }

  @Test
  void facesWithInfiniteCoordinatesAreLeftOutAndCounted() throws IOException {
    Path file = write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1e60 0 0\nf 1 2 3\nf 1 2 4\n");

    Model model = reader.read(file, problems).orElseThrow();

    assertThat(model.polygons()).isEqualTo(1);
    assertThat(problems.list().toString()).contains("a.obj").contains("has 1 face with");
  }

  @Test
  void aFaceOfAVertexThatIsNotThereIsNamedWithItsLine() throws IOException {
    Path file = write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n# a face\nf 1/1 2/1 9/1\n");

    assertThat(reader.read(file, problems)).isEmpty();

    assertThat(problems.list().toString()).contains("a.obj:5").contains("vertex 9, but only 3");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "# nothing\n", "v 0 0 0\nv 1 0 0\n"})
  void anObjWithoutFacesIsSaidToHaveNone(String content) throws IOException {
    assertThat(reader.read(write("a.obj", content), problems)).isEmpty();

    assertThat(problems.list().toString()).contains("a.obj").contains("has no faces");
  }

  @Test
  void aPlyThatIsCutOffIsNotSaidToHaveNoFaces() throws IOException {
    Path file =
        write(
            "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 30\nproperty float x\nproperty float y\n"
                + "property float z\nelement face 10\nproperty list uchar int vertex_indices\n"
                + "end_header\n0 0 0\n1 0 0\n");

    assertThat(reader.read(file, problems)).isEmpty();

    assertThat(messages())
        .singleElement()
        .asString()
        .contains("10 faces")
        .contains("cut off")
        .doesNotContain("has no faces");
  }

  @Test
  void aCutOffGltfIsSaidInOurOwnWords() throws IOException {
    Path file = write("a.gltf", "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,");

    assertThat(reader.read(file, problems)).isEmpty();

    assertThat(messages())
        .singleElement()
        .asString()
        .contains("glTF")
        .contains("damaged")
        .doesNotContain("suitable reader", folder.toString());
  }

  /** Assimp would try its readers of all other formats. */
  @Test
  void aBinaryGltfOfAnotherVersionIsRefused() throws IOException {
    byte[] text = "{\"asset\":{\"version\":\"2.0\"}}  ".getBytes(StandardCharsets.US_ASCII);
    ByteBuffer glb = ByteBuffer.allocate(20 + text.length).order(ByteOrder.LITTLE_ENDIAN);
    glb.put("glTF".getBytes(StandardCharsets.US_ASCII)).putInt(7).putInt(glb.capacity());
    glb.putInt(text.length).put("JSON".getBytes(StandardCharsets.US_ASCII)).put(text);
    Path file = folder.resolve("a.glb");
    Files.write(file, glb.array());

    assertThat(reader.read(file, problems)).isEmpty();

    assertThat(messages()).singleElement().asString().contains("is not a glTF model");
  }

  @Test
  void aBrokenFileIsToldWithTheInlineThatNamesIt() throws IOException {
    write("scenes/broken.gltf", "{}");
    assertThat(readScene("<Inline url='\"broken.gltf\"'/>")).isEmpty();

    assertThat(messages().get(0))
        .containsPattern("\\(the Inline at [^ ]*model\\.x3d:1:[0-9]+ names this file\\)$");
  }

  @Test
  void aPlyOfPointsOnlyHasNoFacesToReduce() throws IOException {
    Path file =
        write(
            "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                + "property float z\nend_header\n0 0 0\n1 0 0\n");

    assertThat(reader.read(file, problems)).isEmpty();

    assertThat(messages()).singleElement().asString().contains("has no faces");
  }
}
