package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.catalogue.NodeView;

class PrototypesTest {
  private static final String CHAIR =
      """
      <ProtoDeclare name='Chair'>
        <ProtoInterface>
          <field name='colour' type='SFColor' accessType='inputOutput' value='0 1 0'/>
          <field name='place' type='SFVec3f' accessType='inputOutput'/>
          <field name='seat' type='MFNode' accessType='initializeOnly'><Group DEF='Default'/></field>
          <field name='moved' type='SFVec3f' accessType='outputOnly'/>
        </ProtoInterface>
        <ProtoBody>
          <Transform DEF='Root' scale='2 2 2'>
            <IS><connect nodeField='translation' protoField='place'/>
                <connect nodeField='translation_changed' protoField='moved'/>
                <connect nodeField='children' protoField='seat'/></IS>
            <Shape><Appearance>
              <Material DEF='M'><IS><connect nodeField='diffuseColor' protoField='colour'/>
                <connect nodeField='emissiveColor' protoField='colour'/></IS></Material>
            </Appearance></Shape>
          </Transform>
          <ColorInterpolator DEF='C'/>
          <ROUTE fromNode='C' fromField='value_changed' toNode='M' toField='specularColor'/>
        </ProtoBody>
      </ProtoDeclare>
      """;

  private final ReaderFixture fixture = new ReaderFixture();

  private static NodeView material(NodeView transform) {
    for (NodeView child : transform.nodes("children")) {
      if (child.type().name().equals("Shape")) {
        return child.node("appearance").node("material");
      }
    }
    throw new AssertionError("no shape");
  }

  @Test
  void anInstanceIsACopyOfTheBodyWithItsOwnValues() {
    X3dFile file =
        fixture.scene(
            CHAIR
                + """
                <ProtoInstance name='Chair' DEF='One'>
                  <fieldValue name='colour' value='1 0 0'/>
                  <fieldValue name='place' value='1 2 3'/>
                  <fieldValue name='seat'><Group DEF='Seat'/></fieldValue>
                </ProtoInstance>
                <ProtoInstance name='Chair'/>
                """);
    fixture.assertClean();
    assertThat(file.nodes())
        .extracting(node -> node.type().name())
        .containsExactly("Transform", "Transform");
    ParsedNode one = file.nodes().get(0);
    assertThat(one.name()).isEqualTo("One");
    assertThat(one.floats("translation")).containsExactly(1, 2, 3);
    assertThat(one.floats("scale")).containsExactly(2, 2, 2);
    assertThat(material(one).floats("diffuseColor")).containsExactly(1, 0, 0);
    assertThat(material(one).floats("emissiveColor")).containsExactly(1, 0, 0);
    assertThat(one.nodes("children").contains(file.named().get("Seat"))).isTrue();
    ParsedNode two = file.nodes().get(1);
    assertThat(two.floats("translation")).containsExactly(0, 0, 0);
    assertThat(material(two).floats("diffuseColor")).containsExactly(0, 1, 0);
    assertThat(material(two)).isNotSameAs(material(one));
    assertThat(file.named()).containsOnlyKeys("One", "Seat");
    assertThat(ReaderFixture.routes(file))
        .containsExactly(
            "C.value_changed -> M.specularColor", "C.value_changed -> M.specularColor");
    assertThat(file.routes().get(0).to()).isSameAs(material(one));
  }

  @Test
  void routesLeadToTheFieldsWithin() {
    X3dFile file =
        fixture.scene(
            CHAIR
                + """
                <ProtoInstance name='Chair' DEF='One'/><Transform DEF='T'/><ColorInterpolator DEF='I'/>
                <ROUTE fromNode='I' fromField='value_changed' toNode='One' toField='set_colour'/>
                <ROUTE fromNode='One' fromField='moved' toNode='T' toField='translation'/>
                <ROUTE fromNode='One' fromField='scale' toNode='T' toField='scale'/>
                """);
    assertThat(ReaderFixture.routes(file))
        .containsExactly(
            "C.value_changed -> M.specularColor",
            "I.value_changed -> M.diffuseColor",
            "I.value_changed -> M.emissiveColor",
            "One.translation -> T.translation");
    fixture.assertOnly(
        "test.x3d:26:1: Chair has no field scale; the ROUTE One.scale to T.scale is left out");
  }

  @Test
  void prototypesMayUseOtherPrototypes() {
    X3dFile file =
        fixture.scene(
            CHAIR
                + """
                <ProtoDeclare name='Row'>
                  <ProtoInterface>
                    <field name='tint' type='SFColor' accessType='inputOutput' value='0 0 1'/>
                  </ProtoInterface>
                  <ProtoBody>
                    <ProtoDeclare name='Pair'><ProtoBody><Group>
                      <ProtoInstance name='Chair'/></Group></ProtoBody></ProtoDeclare>
                    <ProtoInstance name='Chair' DEF='First'>
                      <IS><connect nodeField='colour' protoField='tint'/></IS>
                    </ProtoInstance>
                    <ProtoInstance name='Pair'/>
                  </ProtoBody>
                </ProtoDeclare>
                <ColorInterpolator DEF='I'/>
                <ProtoInstance name='Row' DEF='R'><fieldValue name='tint' value='1 1 0'/></ProtoInstance>
                <ROUTE fromNode='I' fromField='value_changed' toNode='R' toField='tint'/>
                """);
    fixture.assertClean();
    ParsedNode row = file.nodes().get(1);
    assertThat(row.name()).isEqualTo("R");
    assertThat(material(row).floats("diffuseColor")).containsExactly(1, 1, 0);
    assertThat(ReaderFixture.routes(file))
        .contains("I.value_changed -> M.diffuseColor", "I.value_changed -> M.emissiveColor");
  }

  @Test
  void aPrototypeThatContainsItselfIsTold() {
    fixture.scene(
        """
        <ProtoDeclare name='A'><ProtoBody><Group>
          <ProtoInstance name='A'/></Group></ProtoBody></ProtoDeclare>
        <ProtoInstance name='A'/>
        """);
    fixture.assertOnly("test.x3d:3:3: the prototype A contains itself; this instance is left out");
  }

  @Test
  void prototypesThatMultiplyBeyondTheLimitAreLeftOut() {
    StringBuilder text = new StringBuilder();
    text.append("<ProtoDeclare name='P0'><ProtoBody><Group/></ProtoBody></ProtoDeclare>\n");
    for (int i = 1; i < 30; i++) {
      text.append("<ProtoDeclare name='P").append(i).append("'><ProtoBody><Group>");
      text.append(("<ProtoInstance name='P" + (i - 1) + "'/>").repeat(10));
      text.append("</Group></ProtoBody></ProtoDeclare>\n");
    }
    X3dFile file = fixture.scene(text + "<ProtoInstance name='P29'/>");
    fixture.assertOnly(
        "test.x3d:32:1: this instance of the prototype P29 exceeds the limit of 10000 nodes in a"
            + " file; it is left out");
    assertThat(file.nodes()).isEmpty();
  }

  @Test
  void prototypesOfOtherFilesAreToldOnce() {
    X3dFile file =
        fixture.scene(
            """
            <ExternProtoDeclare name='Door' url='"door.x3d#Door"'>
              <field name='open' type='SFBool' accessType='inputOutput'/>
            </ExternProtoDeclare>
            <ProtoInstance name='Door'/><ProtoInstance name='Door'/><Group/>
            """);
    fixture.assertOnly(
        "test.x3d:2:1: the prototype Door cannot be loaded: it is in another file, which is not read here;"
            + " its instances are left out");
    assertThat(file.nodes()).hasSize(1);
  }

  @Test
  void aFaultInABodyIsToldOnce() {
    fixture.scene(
        """
        <ProtoDeclare name='A'><ProtoBody>
          <Transform translation='1 2'/><Teapot/></ProtoBody></ProtoDeclare>
        <ProtoInstance name='A'/><ProtoInstance name='A'/>
        """);
    fixture.assertOnly(
        "test.x3d:3:27: translation: 3 numbers are needed, not 2; the default is used",
        "test.x3d:3:33: unknown element Teapot; it and its children are left out");
  }

  @Test
  void saysWhatIsWrongWithInterfacesAndInstances() {
    fixture.scene(
        CHAIR
            + """
            <ProtoInstance name='Chairs'/>
            <ProtoInstance name='Chair'><fieldValue name='color' value='1 1 1'/></ProtoInstance>
            <Group><IS><connect nodeField='a' protoField='b'/></IS></Group>
            <ProtoDeclare name='B'><ProtoInterface><field name='f' type='SFVec9f'/></ProtoInterface>
            <ProtoBody><Group><IS><connect nodeField='visible' protoField='g'/></IS></Group></ProtoBody>
            </ProtoDeclare><ProtoInstance name='B'/>
            <ProtoDeclare name='C'/>
            """);
    assertThat(fixture.problems.list())
        .extracting(problem -> problem.location().line())
        .containsExactly(23, 24, 25, 26, 27, 29);
    assertThat(fixture.problems.list().get(1).message()).contains("did you mean colour?");
  }

  private static final String KNOWS =
      """
      <ProtoDeclare name='Knows'>
        <ProtoInterface><field name='other' type='SFNode' accessType='initializeOnly'/></ProtoInterface>
        <ProtoBody><Group/>%s</ProtoBody>
      </ProtoDeclare>
      <Group DEF='G'><ProtoInstance name='Knows'>
        <fieldValue name='other'><Group USE='G'/></fieldValue></ProtoInstance></Group>
      """;

  @Test
  void aScriptOfAnInstanceMayKnowWhatTheInstanceStandsIn() {
    X3dFile file =
        fixture.scene(
            KNOWS.formatted(
                "<Script DEF='S'><field name='node' type='SFNode' accessType='initializeOnly'/>"
                    + "<IS><connect nodeField='node' protoField='other'/></IS></Script>"));
    fixture.assertClean();
    assertThat(file.loose().get(0).node("node")).isSameAs(file.named().get("G"));
  }

  @Test
  void noPartOfAnInstanceMayHoldWhatTheInstanceStandsIn() {
    fixture.scene(
        KNOWS.formatted(
            "<Shape><IS><connect nodeField='metadata' protoField='other'/></IS></Shape>"
                + "<Collision><IS><connect nodeField='proxy' protoField='other'/></IS></Collision>"));
    assertThat(fixture.problems.list())
        .extracting(problem -> problem.message())
        .containsExactly(
            "the Group in the field metadata would contain the instance itself; it is left out",
            "the Group in the field proxy would contain the instance itself; it is left out");
  }
}
