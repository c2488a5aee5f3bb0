package org.selectiverenderer.authoring.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/** What versions and their files are called, beside others of the same names. */
class VersionNamesTest extends VaseScene {
  @Test
  void namesThatNoFileMayHaveAreReplaced() throws IOException {
    make(scene(SCENE.replace("'Vase'", "'a/../b:c'")), "a/../b:c");

    assertThat(folder.resolve("inlineNodes/a_.._b_c_v1.x3d")).exists();
  }

  /** Windows opens the serial port of that name instead, whatever follows the dot. */
  @Test
  void aNameOfADeviceIsMadeAnother() throws IOException {
    make(scene(SCENE.replace("'Vase'", "'Com1.left'")), "Com1.left");

    assertThat(folder.resolve("inlineNodes/_Com1.left_v1.x3d")).exists();
  }

  @Test
  void anotherScenesObjectOfTheSameNameKeepsItsFiles() throws IOException {
    Path a = other("a.x3d", shape("Sh", "<Sphere/>"));
    Path b = other("b.x3d", shape("Sh", "<Cone/>"));
    make(a, "Sh", new SimplificationTarget.VertexPercent(10));
    String original = Files.readString(folder.resolve("inlineNodes/Sh_v1.x3d"));

    make(b, "Sh", new SimplificationTarget.VertexPercent(50));

    assertThat(folder.resolve("inlineNodes/Sh_v1.x3d"))
        .usingCharset(StandardCharsets.UTF_8)
        .hasContent(original);
    assertThat(folder.resolve("inlineNodes/Sh2_v1.x3d")).content().contains("<Cone");
    assertThat(b).content().contains("\"inlineNodes/Sh2_v1.x3d\"", "\"inlineNodes/Sh2_v2.x3d\"");
    assertThat(problems.list().toString()).contains("Sh_v1.x3d", "Sh2_v1.x3d");
    assertThat(problems.any()).isFalse();
  }

  @Test
  void namesThatComeToTheSameFileNameGetFilesOfTheirOwn() throws IOException {
    Path scene = other("s.x3d", shape("A/b", "<Sphere/>") + shape("A_b", "<Cone/>"));
    make(scene, "A/b", new SimplificationTarget.VertexPercent(10));

    make(scene, "A_b", new SimplificationTarget.VertexPercent(50));

    assertThat(folder.resolve("inlineNodes/A_b_v1.x3d")).content().contains("<Sphere");
    assertThat(folder.resolve("inlineNodes/A_b2_v1.x3d")).content().contains("<Cone");
  }

  @ParameterizedTest
  @ValueSource(strings = {"Vase_v1.x3d", "Vase_v2.x3d"})
  void aFileByHandIsNotReplaced(String name) throws IOException {
    Files.createDirectories(folder.resolve("inlineNodes"));
    Path hand = Files.writeString(folder.resolve("inlineNodes").resolve(name), "by hand");

    make(scene(SCENE), "Vase");

    assertThat(hand).usingCharset(StandardCharsets.UTF_8).hasContent("by hand");
    assertThat(folder.resolve("inlineNodes/Vase2_v3.x3d")).exists();
  }

  @Test
  void anotherTryWithTheSameSceneUpdatesItsOwnFiles() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", new SimplificationTarget.Polygons(200));
    scene(SCENE);

    make(scene, "Vase", new SimplificationTarget.Polygons(100));

    assertThat(polygons("inlineNodes/Vase_v2.x3d")).isBetween(98, 102);
    assertThat(folder.resolve("inlineNodes/Vase2_v1.x3d")).doesNotExist();
  }

  @Test
  void aFurtherVersionDoesNotReplaceAFileByHand() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", new SimplificationTarget.Polygons(200));
    Path hand = Files.writeString(folder.resolve("inlineNodes/Vase_v3.x3d"), "by hand");

    assertThat(
            plan(
                scene,
                "Vase",
                new SimplificationTarget.Polygons(200),
                new SimplificationTarget.Polygons(90)))
        .isEmpty();

    assertThat(problems.list().toString()).contains("Vase_v3.x3d");
    assertThat(hand).usingCharset(StandardCharsets.UTF_8).hasContent("by hand");
  }

  @Test
  void anObjectNamedLikeAVersionKeepsItsName() throws IOException {
    Path scene = other("s.x3d", shape("Car_v2", "<Sphere/>"));
    make(scene, "Car_v2", new SimplificationTarget.VertexPercent(10));

    make(
        scene,
        "Car_v2",
        new SimplificationTarget.VertexPercent(10),
        new SimplificationTarget.VertexPercent(30));

    assertThat(scene)
        .content()
        .contains("<Inline DEF='Inline_Car_v2_v3' url='\"inlineNodes/Car_v2_v3.x3d\"'/>");
    assertThat(folder.resolve("inlineNodes/Car_v2_v3.x3d")).exists();
  }

  @Test
  void aFurtherInlineHasANameOfItsOwn() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", new SimplificationTarget.Polygons(200));
    Files.writeString(
        scene,
        Files.readString(scene)
            .replace("DEF='Inline_Vase_v2'", "DEF='Low'")
            .replace("DEF='Touch'", "DEF='Low_v3'"));

    make(
        scene,
        "Vase",
        new SimplificationTarget.Polygons(200),
        new SimplificationTarget.Polygons(90));

    assertThat(scene)
        .content()
        .contains("<Inline DEF='Low_v3_2' url='\"inlineNodes/Vase_v3.x3d\"'/>");
  }
}
