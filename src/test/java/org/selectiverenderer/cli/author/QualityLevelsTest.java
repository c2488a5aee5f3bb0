package org.selectiverenderer.cli.author;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;

class QualityLevelsTest {
  private static final String OTHERS = "  <!-- a lamp  -->\n  <Transform   DEF='Lamp'/>\n";
  private static final String HEAD =
      "<?xml version='1.0' encoding='UTF-8'?>\n<X3D profile='Immersive' version='4.0'>\n<Scene>\n"
          + "  <ProximitySensor DEF='Room' size='4 4 4'>\n"
          + "    <MetadataString containerField='metadata' name='enterTimeSchema' "
          + "value='\"Room\"'/>\n"
          + "  </ProximitySensor>\n";
  private static final String TAIL = OTHERS + "</Scene>\n</X3D>\n";
  private static final String SOFA =
      """
        <Transform DEF='Sofa'>
          <Shape>
            <Appearance>
              <ImageTexture url='"wood.png" "https://example.org/wood.png"'/>
            </Appearance>
            <Box/>
          </Shape>
        </Transform>
      """;

  @TempDir Path folder;
  private Path scene;
  private String out = "";
  private String err = "";

  @BeforeEach
  void picture() throws IOException {
    scene = folder.resolve("room.x3d");
    paint("wood.png", BufferedImage.TYPE_INT_ARGB);
    paint("leather.jpg", BufferedImage.TYPE_INT_RGB);
  }

  private void paint(String name, int type) throws IOException {
    BufferedImage image = new BufferedImage(40, 20, type);
    for (int y = 0; y < 20; y++) {
      for (int x = 0; x < 40; x++) {
        image.setRGB(x, y, x < 20 ? 0xff_ff0000 : y < 10 ? 0xff_0000ff : 0x00_00ff00);
      }
    }
    ImageIO.write(image, name.substring(name.lastIndexOf('.') + 1), folder.resolve(name).toFile());
  }

  private void write(String nodes) throws IOException {
    Files.writeString(scene, HEAD + nodes + TAIL);
  }

  private int run(String... args) {
    CommandTestCase command = new CommandTestCase();
    int status = command.execute(args);
    out = command.printed();
    err = command.messages();
    return status;
  }

  private int versions(String... options) {
    String[] all = new String[options.length + 2];
    all[0] = "versions";
    all[1] = scene.toString();
    System.arraycopy(options, 0, all, 2, options.length);
    return run(all);
  }

  private BufferedImage image(String name) throws IOException {
    return ImageIO.read(folder.resolve(name).toFile());
  }

  @Test
  void versionsByPolygonsOfAnObjectWithLevelsAreRefusedAsTheirFilesWouldLoseThem()
      throws IOException {
    write(SOFA);
    versions("--object", "Sofa", "--texture-percent", "50", "--schemas", "Hall,Room");
    String before = Files.readString(scene);
    assertThat(versions("--object", "Sofa", "--polygons", "6")).isOne();
    assertThat(err).contains("room.x3d:").contains("the field Sofa_Texture.url has levels here");
    assertThat(scene).hasContent(before);
    assertThat(folder.resolve("inlineNodes")).doesNotExist();
  }

  @Test
  void smallerPicturesAreWrittenBesideTheOriginalAndSchemasChooseThem() throws IOException {
    write(SOFA);
    byte[] before = Files.readAllBytes(scene);
    assertThat(
            versions(
                "--object", "Sofa", "--texture-percent", "50,10", "--schemas", "Hall,Yard,Room"))
        .as(err)
        .isZero();
    assertThat(out)
        .contains("Switch_Sofa  textures of Sofa_Texture.url:", "new  ", "changed  " + scene);
    assertThat(image("wood_50.png").getWidth()).isEqualTo(20);
    BufferedImage tenth = image("wood_10.png");
    assertThat(tenth.getWidth() + "x" + tenth.getHeight()).isEqualTo("4x2");
    assertThat(tenth.getRGB(0, 0)).isEqualTo(0xff_ff0000);
    assertThat(tenth.getRGB(3, 0)).isEqualTo(0xff_0000ff);
    assertThat(tenth.getRGB(3, 1) >>> 24).as("transparent as the original").isZero();
    assertThat(Files.readAllBytes(folder.resolve("room.x3d.bak"))).isEqualTo(before);
    String after = Files.readString(scene);
    assertThat(after).startsWith(HEAD).endsWith(TAIL);
    assertThat(run("validate", scene.toString())).as(out).isZero();
    assertThat(out).doesNotContain("SR42", "SR43");
    Path walk = Files.writeString(folder.resolve("walk.csv"), "t,x,y,z\n0,0,0,0\n1,0,0,0\n");
    run("simulate", scene.toString(), "--path", walk.toString());
    assertThat(out)
        .contains("field   Switch_Sofa: textures of Sofa_Texture.url level 0 -> 2 (Room)");
    run("simulate", scene.toString(), "--path", walk.toString(), "--quality", "textures=high");
    assertThat(out).doesNotContain("level 0 -> 2");
  }

  @Test
  void theFirstUrlOfALevelIsTheSmallerPicture() throws IOException {
    write(SOFA);
    versions("--object", "Sofa", "--texture-percent", "50");
    assertThat(err).contains("nothing chooses the levels of Switch_Sofa yet", "--schemas");
    assertThat(Files.readString(scene))
        .contains(
            "name='value' value='\"wood.png\" \"https://example.org/wood.png\"'",
            "name='value' value='\"wood_50.png\"'");
  }

  @Test
  void aSmallerPictureThatWasPaintedOverIsKeptBeside() throws IOException {
    write(SOFA);
    versions("--object", "Sofa", "--texture-percent", "50");
    Path smaller = folder.resolve("wood_50.png");
    Files.copy(folder.resolve("wood.png"), smaller, StandardCopyOption.REPLACE_EXISTING);
    byte[] painted = Files.readAllBytes(smaller);
    assertThat(versions("--object", "Switch_Sofa", "--texture-percent", "50")).as(err).isZero();
    assertThat(out).contains("changed  ");
    assertThat(Files.readAllBytes(folder.resolve("wood_50.png.bak"))).isEqualTo(painted);
    assertThat(image("wood_50.png").getWidth()).isEqualTo(20);
  }

  @Test
  void aSecondRunChangesNothingAndOneWithOtherNumbersReplacesTheLevels() throws IOException {
    write(SOFA);
    versions("--object", "Sofa", "--texture-percent", "50", "--shading", "flat");
    String first = Files.readString(scene);
    assertThat(versions("--object", "Switch_Sofa", "--texture-percent", "50", "--shading", "flat"))
        .isZero();
    assertThat(out).contains("unchanged  " + scene);
    assertThat(Files.readString(scene)).isEqualTo(first);
    versions("--object", "Sofa", "--texture-percent", "25");
    assertThat(Files.readString(scene))
        .contains("wood_25.png", "Sofa_Shading.value")
        .doesNotContain("wood_50.png");
  }

  @Test
  void aJpegStaysAJpeg() throws IOException {
    write(SOFA.replace("wood.png", "leather.jpg"));
    assertThat(versions("--object", "Sofa", "--texture-percent", "50")).as(err).isZero();
    assertThat(Files.readAllBytes(folder.resolve("leather_50.jpg"))).startsWith(0xff, 0xd8);
    assertThat(image("leather_50.jpg").getHeight()).isEqualTo(10);
  }

  @Test
  void shadingIsAStringInTheMetadataOfTheAppearance() throws IOException {
    write(SOFA);
    assertThat(versions("--object", "Sofa", "--shading", "vertex,flat")).as(err).isZero();
    assertThat(Files.readString(scene))
        .contains(
            "<MetadataString containerField='metadata' DEF='Sofa_Shading' name='shading'"
                + " value='\"pixel\"'/>",
            "value='\"Sofa_Shading.value\"'",
            "degreeOfConsistency' value='\"0.5\"'");
  }

  @Test
  void anObjectWithVersionsKeepsThemAndItsLevelsFollowTheirSchemas() throws IOException {
    String set =
        "<MetadataSet containerField='value'><MetadataString containerField='value'"
            + " name='degreeOfConsistency' value='\"%s\"'/><MetadataString containerField='value'"
            + " name='schemaBelonginess' value='\"%s\"'/></MetadataSet>";
    write(
        "  <Switch DEF='Switch_Sofa' whichChoice='0'>\n    <MetadataSet containerField='metadata'>"
            + set.formatted("low", "Hall")
            + set.formatted("high", "Room")
            + "</MetadataSet>\n"
            + SOFA
            + "    <Group/>\n  </Switch>\n");
    assertThat(versions("--object", "Sofa", "--texture-percent", "50")).as(err).isZero();
    Path walk = Files.writeString(folder.resolve("walk.csv"), "t,x,y,z\n0,0,0,0\n1,0,0,0\n");
    run("simulate", scene.toString(), "--path", walk.toString());
    assertThat(out).contains("Switch_Sofa: choice 0 -> 1 (Room)", "level 0 -> 1 (Room)");
  }

  @Test
  void nothingOfSomebodyElsesIsOverwritten() throws IOException {
    write(SOFA);
    Files.writeString(folder.resolve("wood_50.png"), "mine");
    String before = Files.readString(scene);
    assertThat(versions("--object", "Sofa", "--texture-percent", "50")).isNotZero();
    assertThat(err).contains("wood_50.png exists already and is another picture");
    assertThat(Files.readString(folder.resolve("wood_50.png"))).isEqualTo("mine");
    assertThat(Files.readString(scene)).isEqualTo(before);
  }

  @Test
  void aPictureThatAnotherSceneShowsStaysAndTheNewOneHasAnotherName() throws IOException {
    write(SOFA);
    versions("--object", "Sofa", "--texture-percent", "50");
    Path smaller = folder.resolve("wood_50.png");
    Files.copy(folder.resolve("wood.png"), smaller, StandardCopyOption.REPLACE_EXISTING);
    byte[] painted = Files.readAllBytes(smaller);
    String before = Files.readString(scene);
    Path other = folder.resolve("other.x3d");
    String[] again = {
      "--object", "Switch_Sofa", "--texture-percent", "50", "--output", other.toString()
    };

    for (int i = 0; i < 2; i++) {
      assertThat(versions(again)).as(err).isZero();
      assertThat(Files.readAllBytes(smaller)).isEqualTo(painted);
      assertThat(folder.resolve("wood_50.png.bak")).doesNotExist();
      assertThat(Files.readString(scene)).isEqualTo(before);
      assertThat(Files.readString(other)).contains("wood_50_2.png").doesNotContain("wood_50.png");
      assertThat(image("wood_50_2.png").getWidth()).isEqualTo(20);
      assertThat(folder.resolve("wood_50_3.png")).doesNotExist();
    }
    assertThat(out).contains("unchanged  ", "wood_50_2.png");

    // In place, too, what the other scene shows stays.
    Files.writeString(other, Files.readString(scene));
    assertThat(versions("--object", "Switch_Sofa", "--texture-percent", "50")).as(err).isZero();
    assertThat(Files.readAllBytes(smaller)).isEqualTo(painted);
    assertThat(Files.readString(scene)).contains("wood_50_2.png");
  }

  @Test
  void aDryRunWritesNothing() throws IOException {
    write(SOFA);
    String before = Files.readString(scene);
    assertThat(versions("--object", "Sofa", "--texture-percent", "50", "--dry-run")).isZero();
    assertThat(out).contains("would be created", "+ ", "fieldQualities");
    assertThat(folder.resolve("wood_50.png")).doesNotExist();
    assertThat(Files.readString(scene)).isEqualTo(before);
  }

  @Test
  void whatOtherObjectsUseTooIsLeftOut() throws IOException {
    write(
        SOFA.replace("<ImageTexture ", "<ImageTexture DEF='Wood' ")
            + "<Shape><Appearance><ImageTexture USE='Wood'/></Appearance><Box/></Shape>\n");
    assertThat(versions("--object", "Sofa", "--texture-percent", "50")).isNotZero();
    assertThat(err)
        .contains(
            "this ImageTexture is used outside of Sofa too, and stays as it is",
            "'Sofa' has no ImageTexture with a picture");
  }

  @Test
  void picturesOutsideOfTheScenesReachAreNotRead() throws IOException {
    Path inner = Files.createDirectory(folder.resolve("inner"));
    scene = inner.resolve("room.x3d");
    write(SOFA.replace("wood.png", "../../../../../../../../etc/wood.png"));
    assertThat(versions("--object", "Sofa", "--texture-percent", "50")).isNotZero();
    assertThat(err).contains("no url of this ImageTexture is a file of this scene");
  }

  @Test
  void versionsInFilesOfTheirOwnAreNamed() throws IOException {
    write(
        "  <Switch DEF='Switch_Sofa'><Inline url='\"inlineNodes/Sofa_v1.x3d\"' load='false'/>"
            + "</Switch>\n");
    assertThat(versions("--object", "Sofa", "--texture-percent", "50")).isNotZero();
    assertThat(err).contains("make them in the files of its versions: \"inlineNodes/Sofa_v1.x3d\"");
  }

  @Test
  void aRuleOfAQualityThatTheSceneLacksIsSaidToChangeNothing() throws IOException {
    write(SOFA);
    Path walk = Files.writeString(folder.resolve("walk.csv"), "t,x,y,z\n0,0,0,0\n1,0,0,0\n");
    String[] simulate = {
      "simulate", scene.toString(), "--path", walk.toString(), "--quality", "textures=low,light=low"
    };
    assertThat(run(simulate)).isOne();
    assertThat(err)
        .contains(
            "no object of the scene has levels of textures, light yet, so setting them changes nothing;"
                + " no object is enriched");

    versions("--object", "Sofa", "--texture-percent", "50", "--schemas", "Hall,Room");
    assertThat(run(simulate)).isOne();
    assertThat(err)
        .contains("levels of light yet, so setting them changes nothing; the scene has textures")
        .containsOnlyOnce("changes nothing");
    simulate[simulate.length - 1] = "textures=low";
    run(simulate);
    assertThat(err).doesNotContain("changes nothing");
  }

  @Test
  void optionsThatMakeNoSenseAreRefused() throws IOException {
    write(SOFA);
    versions("--object", "Sofa");
    assertThat(err).contains("say what the versions differ in");
    versions("--object", "Sofa", "--texture-percent", "25,50");
    assertThat(err).contains("levels fall from below 100 to above 0");
    versions("--object", "Sofa", "--texture-percent", "0");
    assertThat(err).contains("levels fall from below 100 to above 0");
    versions("--object", "Sofa", "--shading", "round");
    assertThat(err).contains("'round' is unknown");
    versions("--object", "Sofa", "--shading", "flat", "--schemas", "A");
    assertThat(err)
        .contains("--shading makes 2 levels with the object as it is")
        .doesNotContain("in two runs");
    versions(
        "--object",
        "Sofa",
        "--texture-percent",
        "50,25",
        "--shading",
        "flat",
        "--schemas",
        "A,B,C");
    assertThat(err).contains("make --texture-percent and --shading in two runs");
    versions("--object", "Sofa", "--shading", "flat", "--vert-percent", "20");
    assertThat(err).contains("are a run of their own");
    versions("--all", "--shading", "flat");
    assertThat(err).contains("take an --object");
    versions("--object", "Vase", "--shading", "flat");
    assertThat(err).contains("there is no node with DEF 'Vase'");
    run("simulate", scene.toString(), "--quality", "colours=high");
    assertThat(err).contains("'colours' is no quality; choose polygons, textures");
    run("simulate", scene.toString(), "--quality", "textures=best");
    assertThat(err).contains("'best' is unknown; choose selective, high or low");
  }
}
