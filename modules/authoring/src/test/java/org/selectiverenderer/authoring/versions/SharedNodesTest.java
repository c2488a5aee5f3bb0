package org.selectiverenderer.authoring.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/** Objects that share nodes with the rest of the scene, as files from VRML97 do, get versions. */
class SharedNodesTest extends VaseScene {
  private static final SimplificationTarget FEW = new SimplificationTarget.VertexPercent(20);

  private static final String HOUSE =
      """
        <Transform DEF='Sofa' translation='1 0 0'>
          <Shape>
            <Appearance DEF='Leather'>
              <Material DEF='Brown' diffuseColor='.4 .2 0'/>
            </Appearance>
            <Sphere DEF='Ball'/>
          </Shape>
        </Transform>
        <Transform DEF='Chair' translation='3 0 0'>
          <Shape><Appearance USE='Leather'/><Sphere USE='Ball'/></Shape>
        </Transform>
        <Transform translation='5 0 0'>
          <Shape>
            <Appearance USE='Leather'/>
            <Box/>
          </Shape>
          <Shape><Appearance><Material USE='Brown'/></Appearance><Cone/></Shape>
        </Transform>
      """;

  @Test
  void theFirstUseInTheSceneBecomesTheNode() throws IOException {
    Path scene = other("s.x3d", HOUSE);
    int all = polygons("s.x3d");

    make(scene, "Sofa", FEW);

    assertThat(problems.list()).isEmpty();
    assertThat(Files.readString(scene))
        .contains(
            """
              <Transform DEF='Chair' translation='3 0 0'>
                <Shape><Appearance DEF='Leather'>
                  <Material DEF='Brown' diffuseColor='.4 .2 0'/>
                </Appearance><Sphere DEF='Ball'/></Shape>
              </Transform>
              <Transform translation='5 0 0'>
                <Shape>
                  <Appearance USE='Leather'/>
                  <Box/>
                </Shape>
                <Shape><Appearance><Material USE='Brown'/></Appearance><Cone/></Shape>
            """);
    assertThat(polygons("s.x3d")).isEqualTo(all);
    assertThat(folder.resolve("inlineNodes/Sofa_v1.x3d"))
        .content()
        .contains("DEF='Leather'", "diffuseColor='0.4 0.2 0'");

    make(scene, "Chair", FEW); // which holds them now
    assertThat(Files.readString(scene))
        .contains(
            """
                  <Appearance DEF='Leather'>
                    <Material DEF='Brown' diffuseColor='.4 .2 0'/>
                  </Appearance>
                  <Box/>
            """);
    assertThat(polygons("s.x3d")).isEqualTo(all);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void whatIsUsedBeforeItIsMovedComesAlong() throws IOException {
    Path scene =
        other(
            "s.x3d",
            """
              <Group DEF='A'>
                <Shape><Appearance><Material DEF='M' diffuseColor='1 0 0'/></Appearance><Sphere/></Shape>
                <Shape><Appearance DEF='L'><Material USE='M'/></Appearance><Sphere/></Shape>
              </Group>
              <Shape><Appearance USE='L'/><Box/></Shape>
              <Shape><Appearance><Material USE='M'/></Appearance><Box/></Shape>
            """);
    make(scene, "A", FEW);
    assertThat(Files.readString(scene))
        .contains(
            "<Shape><Appearance DEF='L'><Material DEF='M' diffuseColor='1 0 0'/></Appearance><Box/>",
            "<Shape><Appearance><Material USE='M'/></Appearance><Box/></Shape>");
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void theFieldOfTheUseStays() throws IOException {
    Path scene =
        other(
            "s.x3d",
            """
              <Shape DEF='A'><Appearance><Material>
                <ImageTexture DEF='T' containerField='diffuseTexture' url='"t.png"'/>
              </Material></Appearance><Sphere/></Shape>
              <Shape><Appearance><ImageTexture USE='T'/></Appearance><Box/></Shape>
              <Shape><Appearance><Material>
                <ImageTexture USE='T' containerField='emissiveTexture'/>
              </Material></Appearance><Box/></Shape>
            """);
    make(scene, "A", FEW);
    assertThat(Files.readString(scene))
        .contains("<Appearance><ImageTexture DEF='T' url='\"t.png\"'/></Appearance>")
        .contains("<ImageTexture USE='T' containerField='emissiveTexture'/>");
  }

  @Test
  void anObjectThatIsUsedAsAWholeShowsItsVersionsEverywhere() throws IOException {
    Path scene =
        other(
            "s.x3d",
            """
              <Shape DEF='Ball'><Sphere/></Shape>
              <Transform translation='3 0 0'><Shape USE='Ball'/></Transform>
              <Group DEF='Two'><Shape><Sphere/></Shape></Group>
              <Transform translation='6 0 0'><Group USE='Two'/></Transform>
            """);
    int all = polygons("s.x3d");
    make(scene, "Ball", FEW);
    make(scene, "Two", FEW);
    assertThat(Files.readString(scene))
        .contains("<Transform translation='3 0 0'><Switch USE='Switch_Ball'/></Transform>")
        .contains("<Transform translation='6 0 0'><Group USE='Two'/></Transform>");
    assertThat(polygons("s.x3d")).isEqualTo(all);
  }
}
