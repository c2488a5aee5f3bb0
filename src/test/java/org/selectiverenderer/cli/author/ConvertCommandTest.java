package org.selectiverenderer.cli.author;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.cli.CommandTestCase;

class ConvertCommandTest extends CommandTestCase {
  @TempDir Path folder;

  private Path scene(String name, String text) throws IOException {
    Files.writeString(folder.resolve("cup_v1.x3d"), "<X3D/>");
    return Files.writeString(folder.resolve(name), text);
  }

  private Path other() throws IOException {
    return Files.createDirectories(folder.resolve("other"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "cup.wrl | #VRML V2.0 utf8~Inline { url \"cup_v1.x3d\" }",
        "cup.x3dv | #X3D V3.3 utf8~PROFILE Immersive~Inline { url [\"cup_v1.x3d\"] }",
        "cup.x3dj | {\"X3D\":{\"@version\":\"4.0\",\"@profile\":\"Immersive\",\"Scene\":{\"-children\":[{\"Inline\":{\"@url\":[\"cup_v1.x3d\"]}}]}}}",
        "cup.xml | <X3D version='4.0' profile='Immersive'><Scene><Inline url='\"cup_v1.x3d\"'/></Scene></X3D>"
      })
  void filesThatAreNotFoundFromTheOtherFolderAreTold(String name, String text) throws IOException {
    Path scene = scene(name, text.replace('~', '\n'));
    Path beside = folder.resolve("converted.x3d");
    assertThat(execute("convert", scene.toString(), beside.toString())).as(messages()).isZero();
    assertThat(messages()).isEmpty();
    Path elsewhere = other().resolve("cup.x3d");
    assertThat(execute("convert", scene.toString(), elsewhere.toString())).isZero();
    assertThat(messages())
        .isEqualTo(
            elsewhere
                + ": 1 file that the scene refers to (cup_v1.x3d) cannot be found from this folder;"
                + " write the output into the folder of the scene, or copy these files too\n");
  }

  @ParameterizedTest
  @ValueSource(strings = {"house.wrl", "house.WRZ", "house.wrl.gz"})
  void whatIsOnlyReadIsNotWrittenAndTheMessageSaysWhatIs(String name) throws IOException {
    Path scene = scene("house.x3d", "<X3D version='4.0' profile='Full'><Scene/></X3D>");
    Path wrl = folder.resolve(name);
    assertThat(execute("convert", scene.toString(), wrl.toString())).isEqualTo(2);
    assertThat(messages())
        .contains(
            "OUT %s: VRML97 and VRML 1.0 are read and not written; use .x3dv for ClassicVRML,"
                    .formatted(wrl)
                + " which VRML97 has become");
    assertThat(wrl).doesNotExist();
  }

  @Test
  void gltfIsWrittenAndWhatItCannotHoldIsTold() throws IOException {
    Path scene = scene("cup.x3d", "<X3D version='4.0' profile='Full'><Scene><Fog/></Scene></X3D>");
    Path glb = folder.resolve("cup.glb");
    assertThat(execute("convert", scene.toString(), glb.toString())).as(messages()).isZero();
    assertThat(messages()).contains("glTF has nothing for Fog; this one and all others are");
    assertThat(Files.readString(glb, StandardCharsets.ISO_8859_1)).startsWith("glTF");
  }

  @Test
  void whatAnEncodingCannotHoldIsToldWithoutAFault() throws IOException {
    Path scene =
        scene(
            "cup.x3d", "<X3D version='4.0' profile='Full'><Scene><Group class='a'/></Scene></X3D>");
    Path output = folder.resolve("cup.x3dv");
    assertThat(execute("convert", scene.toString(), output.toString())).as(messages()).isZero();
    assertThat(messages()).contains("ClassicVRML has no class for elements");
    assertThat(output).exists();
  }

  @ParameterizedTest
  @CsvSource({"cup.x3dv", "cup.x3dj", "cup.glb"})
  void badDataIsAFaultAndTheRestIsWritten(String name) throws IOException {
    Path scene =
        scene(
            "cup.x3d",
            "<X3D version='4.0' profile='Full'><Scene><Bix/><Group DEF='G'/></Scene></X3D>");
    Path output = folder.resolve(name);
    assertThat(execute("convert", scene.toString(), output.toString())).isEqualTo(1);
    assertThat(messages()).contains("unknown element Bix");
    assertThat(output).content(StandardCharsets.ISO_8859_1).contains("G");
  }

  @Test
  void aPictureOfAnotherFormatBecomesPngInGltf() throws IOException {
    ImageIO.write(
        new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB),
        "bmp",
        folder.resolve("wood.bmp").toFile());
    Path scene =
        scene(
            "cup.x3d",
            "<X3D version='4.0' profile='Full'><Scene><Shape><Appearance><Material/>"
                + "<ImageTexture url='\"wood.bmp\"'/></Appearance><Box/></Shape></Scene></X3D>");
    Path glb = folder.resolve("cup.glb");
    assertThat(execute("convert", scene.toString(), glb.toString())).as(messages()).isZero();
    assertThat(messages()).isEmpty();
    assertThat(Files.readString(glb, StandardCharsets.ISO_8859_1)).contains("image/png", "IHDR");
  }

  @Test
  void picturesOfOtherFoldersAreAllowedByTheOptionThatTheMessageNames() throws IOException {
    Path pictures = other();
    ImageIO.write(
        new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB),
        "png",
        pictures.resolve("wood.png").toFile());
    Path own = Files.createDirectories(folder.resolve("own"));
    Path scene = own.resolve("cup.x3d");
    Files.writeString(
        scene,
        "<X3D version='4.0' profile='Full'><Scene><Shape><Appearance><Material/>"
            + "<ImageTexture url='\"../other/wood.png\"'/></Appearance><Box/></Shape></Scene></X3D>");
    Path glb = own.resolve("cup.glb");
    assertThat(execute("convert", scene.toString(), glb.toString())).isEqualTo(1);
    assertThat(messages()).contains("--allow ");
    assertThat(execute("convert", "--allow", pictures.toString(), scene.toString(), glb.toString()))
        .isZero();
    assertThat(Files.readString(glb, StandardCharsets.ISO_8859_1)).contains("image/png");
  }

  @Test
  void aBrokenSceneIsToldOnceAndNotWritten() throws IOException {
    Path scene = scene("cup.x3d", "<X3D version='4.0' profile='Full'><Scene><Group>");
    Path glb = folder.resolve("cup.glb");
    assertThat(execute("convert", scene.toString(), glb.toString())).isEqualTo(1);
    assertThat(messages().lines()).hasSize(1);
    assertThat(messages()).contains("nothing is written");
    assertThat(glb).doesNotExist();
  }

  @Test
  void aSceneIsNotReplacedByItself() throws IOException {
    Path scene = scene("cup.x3d", "<X3D/>");
    assertThat(execute("convert", scene.toString(), scene.toString())).isEqualTo(2);
    assertThat(messages()).contains("is the scene itself, which would be lost");
    assertThat(scene).hasContent("<X3D/>");
  }

  @Test
  void entitiesAreWrittenOut() throws IOException {
    Path scene =
        scene(
            "room.x3d",
            """
            <!DOCTYPE X3D [ <!ENTITY wood "0.4 0.2 0.1">
              <!ENTITY chair "<Shape DEF='Chair'><Box/></Shape>"> ]>
            <X3D version='4.0' profile='Immersive'><Scene>
              <DirectionalLight color='&wood;'/>&chair;
            </Scene></X3D>
            """);
    Path output = folder.resolve("converted.x3d");
    assertThat(execute("convert", scene.toString(), output.toString())).as(messages()).isZero();
    assertThat(messages()).isEmpty();
    assertThat(output)
        .content()
        .contains("color='0.4 0.2 0.1'", "<Shape DEF='Chair'>")
        .doesNotContain("&", "ENTITY");
  }

  @Test
  void aFileOfAnotherKindIsToldAndNotConverted() throws IOException {
    Path scene = scene("page.x3d", "<svg><g/></svg>");
    Path output = folder.resolve("page.x3dj");
    assertThat(execute("convert", scene.toString(), output.toString())).isEqualTo(1);
    assertThat(messages())
        .contains("the root element of a scene must be X3D, not svg; nothing is written");
    assertThat(output).doesNotExist();
  }

  @Test
  void aFolderIsNoScene() {
    assertThat(execute("convert", folder.toString(), folder.resolve("a.x3d").toString()))
        .isEqualTo(2);
    assertThat(messages())
        .isEqualTo("selective-renderer convert: IN " + folder + ": is a folder, not a scene\n");
  }
}
