package org.selectiverenderer.authoring.importing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.HexFormat;
import java.util.concurrent.CancellationException;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UndoableFileWrite;
import org.selectiverenderer.authoring.UndoableFileWrites;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** Models become part of a scene, and nothing of the author's is replaced. */
class ModelImporterTest {
  private static final String PNG =
      "89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de0000000c4944415408d763f8"
          + "cfc0000000030001c9a2d5a70000000049454e44ae426082";

  @TempDir Path folder;
  private Path models;
  private Path scene;

  @BeforeEach
  void files() throws IOException {
    models = Files.createDirectories(folder.resolve("downloads"));
    scene = Files.createDirectories(folder.resolve("work")).resolve("room.x3d");
    Files.writeString(
        scene, "<X3D version='4.0'>\n<Scene>\n  <Group/>\n  <ROUTE/>\n</Scene>\n</X3D>\n");
  }

  private ModelImporter importer() {
    return new ModelImporter(NodeCatalogue.load(), scene, ContentAccessPolicy.none(), () -> false);
  }

  private static String text(ImportedModel model) {
    return new String(model.files().get(0).content(), StandardCharsets.UTF_8);
  }

  private void write(ImportedModel model) throws IOException {
    for (UndoableFileWrite file : model.files()) {
      assertThat(file.file()).doesNotExist().startsWithRaw(scene.getParent());
      Files.createDirectories(file.file().getParent());
      Files.write(file.file(), file.content());
    }
  }

  @Test
  void aMeshIsCopiedUnderANewNameAndPutOnItsPlace() throws IOException {
    Path obj =
        Files.writeString(models.resolve("Old chair.obj"), "v 2 1 0\nv 4 1 0\nv 4 3 2\nf 1 2 3\n");
    ImportedModel chair = importer().copy(obj);
    assertThat(chair.file()).isEqualTo(scene.resolveSibling("Old_chair.x3d"));
    assertThat(text(chair)).contains("<Scene");
    assertThat(chair.onto(new Vector3d(10, 5, 0))).isEqualTo(new Vector3d(7, 4, -1));
    write(chair);
    ImportedModel again = importer().copy(obj);
    assertThat(again.file()).isEqualTo(scene.resolveSibling("Old_chair_2.x3d"));
    write(again);
    SceneDocument document = SceneDocument.of("room.x3d", Files.readAllBytes(scene));
    InlineEdits.Added added =
        new InlineEdits(document, NodeCatalogue.load())
            .add(scene, chair.file(), chair.onto(new Vector3d()));
    document.perform(added.edit());
    assertThat(document.text().toString())
        .contains(
            "  <Group/>\n  <Transform DEF='Old_chair' translation='-3 -1 -1'>\n"
                + "    <Inline url='\"Old_chair.x3d\"'/>\n  </Transform>\n  <ROUTE/>");
    assertThat(
            new InlineEdits(document, NodeCatalogue.load())
                .add(scene, chair.file(), new Vector3d())
                .name())
        .isEqualTo("Old_chair_2");
  }

  @Test
  void picturesOfAModelComeAlong() throws IOException {
    byte[] png = HexFormat.of().parseHex(PNG);
    Files.createDirectories(models.resolve("skins"));
    Files.write(models.resolve("skins/red.png"), png);
    Files.write(models.resolve("box-1.png"), png);
    String data = Base64.getEncoder().encodeToString(png);
    Files.writeString(models.resolve("box.gltf"), gltf("data:image/png;base64," + data));
    Files.writeString(models.resolve("jar.gltf"), gltf("skins/red.png"));
    ImportedModel box = importer().copy(models.resolve("box.gltf"));
    assertThat(box.files())
        .extracting(file -> scene.getParent().relativize(file.file()).toString())
        .containsExactly("box.x3d", "box-1.png");
    assertThat(box.files().get(1).content()).isEqualTo(png);
    assertThat(text(box)).contains("box-1.png");
    ImportedModel jar = importer().copy(models.resolve("jar.gltf"));
    assertThat(jar.files())
        .extracting(file -> scene.getParent().relativize(file.file()).toString().replace('\\', '/'))
        .containsExactly("jar.x3d", "jar-files/skins/red.png");
    assertThat(text(jar)).contains("jar-files/skins/red.png");
    assertThat(jar.problems()).isEmpty();
  }

  private static String gltf(String image) {
    byte[] points = new byte[48];
    java.nio.ByteBuffer out =
        java.nio.ByteBuffer.wrap(points).order(java.nio.ByteOrder.LITTLE_ENDIAN);
    for (float f : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}) {
      out.putFloat(f);
    }
    return """
        {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
         "nodes": [{"mesh": 0}],
         "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 0},
           "material": 0}]}],
         "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
         "textures": [{"source": 0}], "images": [{"uri": "%s"}],
         "buffers": [{"uri": "data:application/octet-stream;base64,%s", "byteLength": 48}],
         "bufferViews": [{"buffer": 0, "byteLength": 36}],
         "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                        "min": [0, 0, 0], "max": [1, 1, 0]}]}
        """
        .formatted(image, Base64.getEncoder().encodeToString(points))
        .replace(", \"TEXCOORD_0\": 0", "");
  }

  @Test
  void aSceneOfAnyEncodingIsCopiedWithWhatItNames() throws IOException {
    Files.writeString(
        models.resolve("lamp.x3d"),
        "<X3D version='4.0'><Scene><Inline url='\"bulb.x3d\"'/></Scene></X3D>");
    Files.writeString(
        models.resolve("bulb.x3d"),
        "<X3D version='4.0'><Scene><Shape><Box/></Shape></Scene></X3D>");
    ImportedModel lamp = importer().copy(models.resolve("lamp.x3d"));
    assertThat(lamp.files())
        .extracting(f -> f.file().getFileName().toString())
        .containsExactly("lamp.x3d", "bulb.x3d");
    assertThat(text(lamp)).contains("lamp-files/bulb.x3d");
    Files.writeString(
        models.resolve("house.wrl"), "#VRML V1.0 ascii\nSeparator { Cube { width 2 } }\n");
    assertThat(text(importer().copy(models.resolve("house.wrl")))).contains("<Box");
    Files.writeString(
        models.resolve("hut.wrl"), "#VRML V2.0 utf8\nShape { geometry Cone { height 3 } }\n");
    assertThat(text(importer().copy(models.resolve("hut.wrl")))).contains("<Cone");
  }

  @Test
  void aLinkLeavesTheModelWhereItIs() throws IOException {
    Path own =
        Files.writeString(scene.resolveSibling("cup.obj"), "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
    ImportedModel cup = importer().link(own);
    assertThat(cup.files()).isEmpty();
    assertThat(cup.bounds().orElseThrow().maxY()).isEqualTo(2);
    assertThat(importer().mayLink(own)).isTrue();
    assertThat(importer().mayLink(models.resolve("lamp.x3d"))).isFalse();
  }

  @Test
  void whatCannotBeReadIsToldInASentence() throws IOException {
    Path broken = Files.writeString(models.resolve("broken.glb"), "glTF and then nothing");
    assertThatThrownBy(() -> importer().copy(broken))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("broken.glb");
    assertThatThrownBy(() -> importer().link(broken)).isInstanceOf(IOException.class);
    Path text = Files.writeString(models.resolve("notes.txt"), "no scene at all");
    assertThatThrownBy(() -> importer().copy(text)).isInstanceOf(IOException.class);
    assertThatThrownBy(() -> importer().copy(models.resolve("gone.obj")))
        .isInstanceOf(IOException.class);
    try (var there = Files.list(scene.getParent())) {
      assertThat(there).containsExactly(scene);
    }
  }

  @Test
  void aPictureThatIsNoBase64StaysAndTheRestComesAlong() {
    EmbeddedPictures pictures = new EmbeddedPictures(scene);
    String text = "<a url='data:image/png;base64,A'/><b url='data:image/png;base64,AAAA'/>";
    assertThat(pictures.takenFrom(text))
        .isEqualTo("<a url='data:image/png;base64,A'/><b url='room-1.png'/>");
    assertThat(pictures.contents()).hasSize(1);
    assertThat(pictures.faults()).hasSize(1);
  }

  @Test
  void anInlineDeclaresItsComponent() throws IOException {
    Path chair = scene.resolveSibling("chair.x3d");
    SceneDocument document =
        SceneDocument.of(
            "room.x3d",
            "<X3D profile='Core' version='4.0'>\n<Scene>\n</Scene>\n</X3D>\n".getBytes());
    document.perform(
        new InlineEdits(document, NodeCatalogue.load()).add(scene, chair, new Vector3d()).edit());
    assertThat(document.text().toString())
        .contains("<component name='Networking' level='2'/>")
        .contains("<component name='Grouping' level='1'/>");
  }

  @Test
  void aModelThatIsTooLargeWithItsFilesIsRefusedBeforeTheyAreRead() throws IOException {
    Files.writeString(
        models.resolve("wall.x3d"),
        "<X3D version='4.0'><Scene><Shape><Appearance><ImageTexture url='\"big.png\"'/>"
            + "</Appearance><Box/></Shape></Scene></X3D>");
    try (var big = new java.io.RandomAccessFile(models.resolve("big.png").toFile(), "rw")) {
      big.setLength(3L << 30); // sparse, and more than an array can hold
    }
    assertThatThrownBy(() -> importer().copy(models.resolve("wall.x3d")))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("more than 1 GB");
    try (var big = new java.io.RandomAccessFile(models.resolve("big.obj").toFile(), "rw")) {
      big.setLength(3L << 30);
    }
    assertThatThrownBy(() -> importer().copy(models.resolve("big.obj")))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("more than 1 GB");
  }

  @Test
  void namesOfAllKindsComeAlong() throws IOException {
    String longest = "m".repeat(251);
    Files.createDirectories(models.resolve("Äpfel #1"));
    Files.write(models.resolve("Äpfel #1/50% grün.png"), HexFormat.of().parseHex(PNG));
    Files.writeString(models.resolve(longest + ".mtl"), "newmtl a\nmap_Kd Äpfel #1/50% grün.png\n");
    Files.writeString(
        models.resolve(longest + ".obj"),
        "mtllib "
            + longest
            + ".mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\n"
            + "f 1/1 2/2 3/3\n");
    ImportedModel model = importer().copy(models.resolve(longest + ".obj"));
    assertThat(model.problems()).isEmpty();
    write(model);
    assertThat(model.files()).hasSize(2);
    ImportedModel again = importer().copy(model.file());
    assertThat(again.problems()).isEmpty();
    assertThat(importer().link(model.file()).problems()).isEmpty();
  }

  @Test
  void aCancelledImportLeavesNothing() throws IOException {
    Path obj =
        Files.writeString(models.resolve("chair.obj"), "v 2 1 0\nv 4 1 0\nv 4 3 2\nf 1 2 3\n");
    ImportedModel chair = importer().copy(obj);
    assertThatThrownBy(
            () ->
                UndoableFileWrites.write(
                    chair.files(),
                    () -> {
                      throw new CancellationException();
                    }))
        .isInstanceOf(CancellationException.class);
    assertThat(chair.file()).doesNotExist();
    UndoableFileWrites written = UndoableFileWrites.write(chair.files(), () -> {});
    assertThat(chair.file()).exists();
    written.withdraw();
    assertThat(chair.file()).doesNotExist();
  }
}
