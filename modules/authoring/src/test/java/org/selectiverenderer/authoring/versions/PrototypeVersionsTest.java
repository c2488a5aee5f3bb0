package org.selectiverenderer.authoring.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/** Versions of objects in scenes with prototypes. */
class PrototypeVersionsTest extends VaseScene {
  private static final SimplificationTarget FEW = new SimplificationTarget.VertexPercent(20);

  @Test
  void namesInAPrototypeAreOthersThanThoseOfTheScene() throws IOException {
    Path scene =
        other(
            "s.x3d",
            """
              <ProtoDeclare name='P'><ProtoBody>
                <Group><Shape DEF='Vase'><Sphere/></Shape><Shape USE='Vase'/></Group>
              </ProtoBody></ProtoDeclare>
              <ProtoInstance name='P'/>
            """
                + shape("Vase", "<Sphere/>")
                + shape("Cup", "<Sphere/>"));
    String before = Files.readString(scene);
    make(scene, "Vase", FEW);
    assertThat(problems.list()).isEmpty();
    assertThat(Files.readString(scene))
        .startsWith(
            before.substring(0, before.indexOf("  <Shape DEF='Vase'><Sphere/></Shape>\n  ")))
        .contains("<Switch DEF='Switch_Vase'");
  }

  @Test
  void aNodeOfAPrototypeIsNoObjectOfTheScene() throws IOException {
    Path scene =
        other(
            "s.x3d",
            "<ProtoDeclare name='P'><ProtoBody>"
                + shape("Vase", "<Sphere/>")
                + "</ProtoBody></ProtoDeclare><ProtoInstance name='P'/>");
    assertThat(plan(scene, "Vase", FEW)).isEmpty();
    assertThat(problems.list().toString()).contains("is part of a prototype");
  }

  private static final String CHAIR =
      """
        <ProtoDeclare name='Chair'>
          <ProtoInterface>
            <field name='colour' type='SFColor' accessType='inputOutput' value='0 0 1'/>
          </ProtoInterface>
          <ProtoBody>
            <Transform DEF='Body'>
              <Shape><Appearance DEF='Look'><Material>
                <IS><connect nodeField='diffuseColor' protoField='colour'/></IS>
              </Material></Appearance><Sphere/></Shape>
              <Transform translation='0 2 0'>
                <Shape><Appearance USE='Look'/><Sphere radius='.5'/></Shape>
              </Transform>
            </Transform>
            <TimeSensor DEF='Clock' loop='true'/>
            <PositionInterpolator DEF='Path' key='0 1' keyValue='0 0 0 0 1 0'/>
            <ROUTE fromNode='Clock' fromField='fraction_changed' toNode='Path' toField='set_fraction'/>
            <ROUTE fromNode='Path' fromField='value_changed' toNode='Body' toField='translation'/>
          </ProtoBody>
        </ProtoDeclare>
      """;

  @Test
  void anInstanceOfAPrototypeGetsVersionsOfWhatItDraws() throws IOException {
    String instance =
        "<ProtoInstance name='Chair' DEF='Chair1'><fieldValue name='colour' value='1 0 0'/>"
            + "</ProtoInstance>";
    Path scene = other("s.x3d", CHAIR + "  " + instance + "\n");
    String before = Files.readString(scene);
    int all = polygons("s.x3d");

    VersionsEdit plan = make(scene, "Chair1", FEW);

    assertThat(Files.readString(scene))
        .isEqualTo(
            before.replace(
                instance,
                """
                <Switch DEF='Switch_Chair1' whichChoice='0'>
                    <Inline DEF='Inline_Chair1_v1' url='"inlineNodes/Chair1_v1.x3d"'/>
                    <Inline DEF='Inline_Chair1_v2' url='"inlineNodes/Chair1_v2.x3d"'/>
                  </Switch>"""));
    assertThat(plan.versions().get(0).polygons()).isEqualTo(all);
    assertThat(polygons("s.x3d")).isEqualTo(all);
    assertThat(polygons("inlineNodes/Chair1_v2.x3d")).isLessThan(all / 3);
    assertThat(folder.resolve("inlineNodes/Chair1_v1.x3d"))
        .content()
        .contains("diffuseColor='1 0 0'")
        .contains("fromField='fraction_changed'")
        .contains("toNode='Chair1' toField='translation'");
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void instancesInAGroupAndWithoutANameGetVersionsToo() throws IOException {
    Path scene =
        other(
            "s.x3d",
            CHAIR
                + """
                <Group DEF='Row'>
                  <ProtoInstance name='Chair'/>
                  <Transform translation='3 0 0'><ProtoInstance name='Chair'/></Transform>
                </Group>
                <ProtoInstance name='Chair' containerField='children'/>
                """);
    int all = polygons("s.x3d");
    make(scene, "Row", FEW);
    assertThat(polygons("inlineNodes/Row_v1.x3d")).isEqualTo(2 * all / 3);
    assertThat(Files.readString(folder.resolve("inlineNodes/Row_v1.x3d")))
        .contains("DEF='Look'", "DEF='Look_2'", "USE='Look_2'", "DEF='Body_2'", "'Clock_2'");
    int start = Files.readString(scene).lastIndexOf("<ProtoInstance");
    VersionsEdit.Request request =
        new VersionsEdit.Request(scene, "Chair", List.of(FEW), "inlineNodes").at(start);
    plan(request).orElseThrow().write();
    assertThat(Files.readString(scene)).contains("<Switch DEF='Switch_Chair' whichChoice='0'>");
    assertThat(polygons("s.x3d")).isEqualTo(all);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void aPrototypeOfAnotherFileFindsItsFilesFromTheVersions() throws IOException {
    Files.createDirectory(folder.resolve("protos"));
    Files.writeString(folder.resolve("protos/wood.png"), "");
    other(
        "protos/chairs.x3d",
        """
        <ProtoDeclare name='Stool'><ProtoBody><Shape><Appearance>
          <ImageTexture url='"wood.png"'/></Appearance><Sphere/></Shape></ProtoBody></ProtoDeclare>
        """);
    Path scene =
        other(
            "s.x3d",
            """
            <ExternProtoDeclare name='Stool' url='"protos/chairs.x3d#Stool"'/>
            <ProtoInstance name='Stool' DEF='Stool1'/>
            """);
    make(scene, "Stool1", FEW);
    for (int version = 1; version <= 2; version++) {
      assertThat(folder.resolve("inlineNodes/Stool1_v" + version + ".x3d"))
          .content()
          .contains("\"../protos/wood.png\"");
    }
  }

  @Test
  void aSwitchThatAnAuthorHasMadeAroundAnInstanceTakesTheVersions() throws IOException {
    String instance = "<ProtoInstance name='Chair' DEF='Chair1'/>";
    Path scene =
        other(
            "s.x3d",
            CHAIR
                + "<Switch DEF='Switch_Chair1' whichChoice='0'>\n  "
                + instance
                + "\n</Switch>\n");
    String before = Files.readString(scene);
    int all = polygons("s.x3d");
    make(scene, "Switch_Chair1", FEW);
    assertThat(Files.readString(scene))
        .isEqualTo(
            before.replace(
                instance,
                """
                <Inline DEF='Inline_Chair1_v1' url='"inlineNodes/Chair1_v1.x3d"'/>
                  <Inline DEF='Inline_Chair1_v2' url='"inlineNodes/Chair1_v2.x3d"'/>"""));
    assertThat(polygons("s.x3d")).isEqualTo(all);
    make(scene, "Switch_Chair1", new SimplificationTarget.VertexPercent(50));
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void whatAPrototypeHasBesidesGeometryIsSaidToBeLost() throws IOException {
    Path scene =
        other(
            "s.x3d",
            "<ProtoDeclare name='P'><ProtoBody><Group><Shape><Sphere/></Shape><TouchSensor/></Group>"
                + "</ProtoBody></ProtoDeclare>\n<ProtoInstance name='P' DEF='A'/>");
    assertThat(plan(scene, "A", FEW)).isPresent();
    assertThat(problems.list().toString()).contains("s.x3d:3:1").contains("the TouchSensor is not");
  }
}
