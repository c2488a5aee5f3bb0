package org.selectiverenderer.authoring.editing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Fields of a prototype's interface, listed and written at its instances. */
class PrototypeFieldsTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();
  private static final String SCENE =
      """
      <X3D><Scene>
        <ProtoDeclare name="Chair">
          <ProtoInterface>
            <field name="colour" type="SFColor" accessType="inputOutput" value="1 0 0"
              appinfo="of the seat"/>
            <field name="glass" type="SFFloat" accessType="initializeOnly"/>
            <field name="low" type="SFBool" accessType="initializeOnly" value="true"/>
            <field name="labels" type="MFString" accessType="inputOutput"/>
            <field name="name" type="SFString" accessType="inputOutput" value="oak"/>
            <field name="DEF" type="SFString" accessType="inputOutput"/>
            <field name="USE" type="SFString" accessType="inputOutput"/>
            <field name="bboxSize" type="SFVec2f" accessType="inputOutput"/>
            <field name="seat" type="SFNode" accessType="inputOutput"><Shape DEF="Seat"/></field>
            <field name="legs" type="MFNode" accessType="inputOutput"/>
            <field name="hit" type="SFTime" accessType="outputOnly"/>
            <field name="move" type="SFTime" accessType="inputOnly"/>
            <field name="odd" type="SFUnheardOf" accessType="inputOutput"/>
          </ProtoInterface>
          <ProtoBody>
            <Shape><Appearance><Material shininess="0.4">
              <IS><connect nodeField="diffuseColor" protoField="colour"/>
                <connect nodeField="shininess" protoField="glass"/></IS>
            </Material></Appearance></Shape>
            <ProtoDeclare name="Leg"><ProtoInterface>
              <field name="inner" type="SFFloat" accessType="inputOutput"/>
            </ProtoInterface><ProtoBody><Group/></ProtoBody></ProtoDeclare>
            <ProtoInstance name="Leg" DEF="InnerLeg"/>
          </ProtoBody>
        </ProtoDeclare>
        <ProtoDeclare name="Leg"><ProtoInterface>
          <field name="outer" type="SFInt32" accessType="inputOutput"/>
        </ProtoInterface><ProtoBody><Group/></ProtoBody></ProtoDeclare>
        <ExternProtoDeclare name="Lamp" url='"lamp.x3d#Lamp"'>
          <field name="on" type="SFBool" accessType="inputOutput"/>
        </ExternProtoDeclare>
        <ProtoInstance name="Chair" DEF="Plain"/><!-- stays -->
        <ProtoInstance name="Chair"   DEF='Given'>
          <fieldValue name="colour"  value='0 1 0'/>
          <fieldValue name="legs"><Group DEF="LegA"/><!-- one --><Group DEF="LegB"/></fieldValue>
          <fieldValue name="nonsense" value="1"/>
        </ProtoInstance>
        <ProtoInstance USE="Plain"/>
        <ProtoInstance name="Leg" DEF="OuterLeg"/>
        <ProtoInstance name="Lamp" DEF="Lamp1"/>
        <ProtoInstance name="Unknown" DEF="U"><fieldValue name="a" value="1"/></ProtoInstance>
      </Scene></X3D>
      """;

  private SceneDocument document = document(SCENE);

  private static SceneDocument document(String text) {
    try {
      return SceneDocument.of("scene.x3d", text.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private FieldEdits edits() {
    return new FieldEdits(document);
  }

  private DocumentElement at(String text) {
    return document.tree().orElseThrow().at(document.text().toString().indexOf(text)).orElseThrow();
  }

  private DocumentElement named(String def) {
    return document.tree().orElseThrow().named(def).orElseThrow();
  }

  private List<NodeField> fields(DocumentElement of) {
    return NodeFieldList.of(document, CATALOGUE, of);
  }

  private List<String> declared(DocumentElement of) {
    return fields(of).stream()
        .filter(field -> field.ofPrototype().isPresent())
        .map(NodeField::name)
        .toList();
  }

  private NodeField field(DocumentElement of, String name) {
    return fields(of).stream()
        .filter(field -> field.ofPrototype().isPresent() && field.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  private Optional<String> wrong(String def, String name, String value) {
    return edits().wrong(named(def), field(named(def), name), value);
  }

  private void set(String def, String name, String value) {
    document.perform(edits().set(named(def), field(named(def), name), value));
  }

  private void unset(String def, String name) {
    document.perform(edits().unset(named(def), field(named(def), name)));
  }

  private void reads(String text) {
    assertThat(document.snapshot().text()).isEqualTo(text);
  }

  @Test
  void theInterfaceIsListedWithTypesAndDefaults() {
    List<NodeField> all = fields(named("Plain"));
    assertThat(all.stream().filter(field -> field.ofPrototype().isEmpty()))
        .extracting(NodeField::name)
        .containsExactly("name", "DEF");
    assertThat(declared(named("Plain")))
        .containsExactly(
            "colour", "glass", "low", "labels", "name", "DEF", "USE", "bboxSize", "seat", "legs");
    NodeField colour = field(named("Plain"), "colour");
    assertThat(colour.kind()).isEqualTo(NodeField.Kind.COLOR);
    assertThat(colour.defaultText()).isEqualTo("1 0 0");
    assertThat(colour.written()).isEmpty();
    assertThat(colour.ofPrototype().orElseThrow().info()).isEqualTo("of the seat");
    assertThat(colour.about()).isEqualTo("SFColor, 1 0 0 by default, from 0, to 1");
    assertThat(field(named("Given"), "colour").written()).contains("0 1 0");
    assertThat(field(named("Plain"), "low").kind()).isEqualTo(NodeField.Kind.BOOLEAN);
    // what the interface leaves out is the value of the node that IS connects
    assertThat(field(named("Plain"), "glass").defaultText()).isEqualTo("0.4");
  }

  @Test
  void theDeclarationIsThatOfTheScope() {
    assertThat(declared(at("<ProtoInstance name=\"Leg\" DEF=\"InnerLeg\"")))
        .containsExactly("inner");
    assertThat(declared(named("OuterLeg"))).containsExactly("outer");
    assertThat(declared(named("U"))).containsExactly("a");
    assertThat(wrong("U", "a", "2")).isEmpty(); // nobody knows
  }

  @Test
  void anExternprotoHasItsFieldsAndDefaultsInItsFile() {
    NodeField on = field(named("Lamp1"), "on");
    assertThat(on.kind()).isEqualTo(NodeField.Kind.BOOLEAN);
    assertThat(on.defaultText()).isEmpty();
    assertThat(on.ofPrototype().orElseThrow().external()).isTrue();
    set("Lamp1", "on", "true");
    reads(
        SCENE.replace(
            "<ProtoInstance name=\"Lamp\" DEF=\"Lamp1\"/>",
            "<ProtoInstance name=\"Lamp\" DEF=\"Lamp1\">\n"
                + "    <fieldValue name=\"on\" value=\"true\"/>\n"
                + "  </ProtoInstance>"));
  }

  @Test
  void aValueIsWrittenAndTakenBackInOneStepEach() {
    set("Given", "colour", "0 0 1");
    String changed = SCENE.replace("'0 1 0'", "'0 0 1'");
    reads(changed);
    set("Given", "labels", "\"a & b\" \"c\"");
    reads(
        changed.replace(
            "<fieldValue name=\"nonsense\" value=\"1\"/>\n",
            "<fieldValue name=\"nonsense\" value=\"1\"/>\n"
                + "    <fieldValue name=\"labels\" value='\"a &amp; b\" \"c\"'/>\n"));
    unset("Given", "labels");
    unset("Given", "nonsense");
    unset("Given", "colour");
    reads(
        SCENE
            .replace("    <fieldValue name=\"colour\"  value='0 1 0'/>\n", "")
            .replace("    <fieldValue name=\"nonsense\" value=\"1\"/>\n", ""));
    assertThat(document.history().names())
        .startsWith("Set colour of ProtoInstance Given", "Set labels of ProtoInstance Given")
        .endsWith("Reset colour of ProtoInstance Given");
    for (int i = 0; i < 5; i++) {
      document.history().undo();
    }
    reads(SCENE);
    assertThat(edits().unset(named("Plain"), field(named("Plain"), "colour")).isEmpty()).isTrue();
    assertThat(edits().set(named("Given"), field(named("Given"), "colour"), "0 1 0").isEmpty())
        .isTrue();
  }

  @Test
  void namesOfAttributesAreFieldsOfTheirOwn() {
    for (String name : List.of("name", "DEF", "USE")) {
      assertThat(wrong("Plain", name, "x y")).isEmpty();
      set("Plain", name, "x y");
      String with = "<fieldValue name=\"" + name + "\" value=\"x y\"/>";
      reads(
          SCENE.replace(
              "<ProtoInstance name=\"Chair\" DEF=\"Plain\"/>",
              "<ProtoInstance name=\"Chair\" DEF=\"Plain\">\n    "
                  + with
                  + "\n  </ProtoInstance>"));
      assertThat(document.attribute(named("Plain"), "name")).contains("Chair");
      document.history().undo();
    }
    reads(SCENE);
  }

  @Test
  void wrongValuesAreToldWithTheReason() {
    assertThat(wrong("Plain", "colour", "1 0")).isPresent();
    assertThat(wrong("Plain", "colour", "1 0 2").orElseThrow()).contains("at most 1");
    assertThat(wrong("Plain", "glass", "2").orElseThrow()).contains("at most 1");
    assertThat(wrong("Plain", "low", "yes")).isPresent();
    assertThat(wrong("Plain", "bboxSize", "1 2")).isEmpty(); // no size of a box
    assertThat(wrong("Given", "nonsense", "1").orElseThrow())
        .contains("Chair has no field nonsense");
    NodeField name = fields(named("Plain")).get(0);
    assertThat(edits().wrong(named("Plain"), name, "Lamp")).isEmpty();
    assertThat(edits().wrong(named("Plain"), name, "Sofa").orElseThrow()).contains("Sofa");
    assertThat(edits().wrongReset(List.of(named("Plain")), name).orElseThrow())
        .contains("needs the name");
    assertThat(edits().wrongReset(List.of(named("Plain")), field(named("Plain"), "DEF"))).isEmpty();
  }

  @Test
  void nodesAreShownAndNotWritten() {
    NodeField legs = field(named("Given"), "legs");
    assertThat(legs.kind()).isEqualTo(NodeField.Kind.NODES);
    assertThat(legs.ofPrototype().orElseThrow().nodes())
        .extracting(DocumentElement::toString)
        .containsExactly("Group LegA", "Group LegB");
    assertThat(legs.readOnly()).isPresent();
    NodeField seat = field(named("Plain"), "seat");
    assertThat(seat.written()).isEmpty();
    assertThat(seat.ofPrototype().orElseThrow().nodes())
        .extracting(DocumentElement::toString)
        .containsExactly("Shape Seat");
    assertThat(wrong("Plain", "seat", "x")).isPresent();
  }

  @Test
  void aUseHasNoValuesOfItsOwn() {
    assertThat(declared(at("<ProtoInstance USE"))).isEmpty();
  }

  @Test
  void aRepeatedValueIsChangedWhereItCountsAndResetEverywhere() {
    String twice =
        SCENE.replace(
            "<ProtoInstance name=\"Chair\" DEF=\"Plain\"/>",
            "<ProtoInstance name=\"Chair\" DEF=\"Plain\"><fieldValue name=\"low\" value=\"true\"/>"
                + "<fieldValue name=\"low\" value=\"false\"/></ProtoInstance>");
    document = document(twice);
    assertThat(field(named("Plain"), "low").written()).contains("false");
    set("Plain", "low", "true");
    reads(twice.replace("value=\"false\"/></", "value=\"true\"/></"));
    unset("Plain", "low");
    reads(
        SCENE.replace(
            "<ProtoInstance name=\"Chair\" DEF=\"Plain\"/>",
            "<ProtoInstance name=\"Chair\" DEF=\"Plain\"></ProtoInstance>"));
  }

  @Test
  void aValueFromAnEntityIsLeftAndAPrefixKept() {
    document =
        document(
            """
            <!DOCTYPE X3D [<!ENTITY red "1 0 0">]>
            <x:X3D xmlns:x='http://www.web3d.org/specifications/x3d-namespace'><x:Scene>
            <x:ProtoDeclare name='P'><x:ProtoInterface>
            <x:field name='c' type='SFColor' accessType='inputOutput'/>
            </x:ProtoInterface><x:ProtoBody><x:Group/></x:ProtoBody></x:ProtoDeclare>
            <x:ProtoInstance name='P' DEF='A'/>
            <x:ProtoInstance name='P' DEF='B'>
            <x:fieldValue name='c' value='&red;'/></x:ProtoInstance>
            </x:Scene></x:X3D>
            """);
    set("A", "c", "0 0 1");
    assertThat(document.text())
        .contains(
            "<x:ProtoInstance name='P' DEF='A'>\n"
                + "  <x:fieldValue name='c' value='0 0 1'/>\n</x:ProtoInstance>");
    assertThat(field(named("B"), "c").readOnly().orElseThrow()).contains("entity");
    NodeField c = field(named("B"), "c");
    assertThatThrownBy(() -> edits().set(named("B"), c, "0 0 1"))
        .isInstanceOf(EditRejectedException.class);
  }

  @Test
  void severalOfAKindGetAValueInOneStep() {
    List<DocumentElement> selected =
        List.of(named("OuterLeg"), named("Given"), named("Lamp1"), named("Plain"));
    List<DocumentElement> chairs = edits().alike(named("Plain"), selected);
    assertThat(chairs).containsExactly(named("Plain"), named("Given"));
    document.perform(edits().set(chairs, field(named("Plain"), "colour"), "0 0 1"));
    assertThat(document.history().names()).containsExactly("Set colour of 2 nodes");
    assertThat(field(named("Plain"), "colour").written()).contains("0 0 1");
    assertThat(field(named("Given"), "colour").written()).contains("0 0 1");
    document.perform(edits().unset(chairs, field(named("Plain"), "colour")));
    assertThat(document.text()).doesNotContain("0 0 1");
    document.history().undo();
    document.history().undo();
    reads(SCENE);
    NodeField def = fields(named("Plain")).get(1);
    document.perform(edits().set(chairs, def, "Other")); // a name is of one node
    reads(SCENE.replace("\"Plain\"", "\"Other\""));
  }

  @Test
  void instancesOfUnknownPrototypesAreAlikeByTheirNames() {
    document =
        document(
            "<X3D><Scene><ProtoInstance name='Chair' DEF='A'/><ProtoInstance name='Lamp' DEF='B'/>"
                + "<ProtoInstance name='Chair ' DEF='C'/></Scene></X3D>");
    List<DocumentElement> all = List.of(named("A"), named("B"), named("C"));
    assertThat(edits().alike(named("A"), all)).containsExactly(named("A"), named("C"));
  }

  @Test
  void theNameOfItsPrototypeIsOfOneInstance() {
    List<DocumentElement> chairs = List.of(named("Plain"), named("Given"));
    NodeField name = fields(named("Plain")).get(0);
    assertThat(edits().wrong(chairs, name, "Lamp")).isEmpty();
    document.perform(edits().set(chairs, name, "Lamp"));
    reads(SCENE.replace("name=\"Chair\" DEF=\"Plain\"", "name=\"Lamp\" DEF=\"Plain\""));
    document.history().undo();
    assertThat(edits().wrongReset(chairs, name).orElseThrow()).contains("needs the name");
  }

  /** The first of them can take the value; that says nothing about the others. */
  @Test
  void aValueThatAnotherCannotTakeIsRefusedWithItsName() {
    String many = "9 ".repeat(20_000);
    document =
        document(
            """
            <!DOCTYPE X3D [<!ENTITY red "1 0 0">]>
            <X3D><Scene><ProtoDeclare name='P'><ProtoInterface>
            <field name='c' type='SFColor' accessType='inputOutput'/>
            <field name='m' type='MFFloat' accessType='inputOutput'/>
            </ProtoInterface><ProtoBody><Group/></ProtoBody></ProtoDeclare>
            <ProtoInstance name='P' DEF='A'><fieldValue name='c' value='0 1 0'/></ProtoInstance>
            <ProtoInstance name='P' DEF='B'><fieldValue name='c' value='&red;'/>
            <fieldValue name='m' value='%s'/></ProtoInstance>
            <Material DEF='M' diffuseColor='0 1 0'/>
            <Material DEF='N' diffuseColor='&red;'/>
            <ProtoInstance name='Q' DEF='U'/>
            <ProtoInstance name='Q' DEF='V'><fieldValue name='x'><Group/></fieldValue></ProtoInstance>
            <ProtoInstance name='Q' DEF='W'><fieldValue name='x' value='1'/></ProtoInstance>
            </Scene></X3D>
            """
                .formatted(many));
    List<DocumentElement> instances = List.of(named("A"), named("B"));
    NodeField c = field(named("A"), "c");
    assertThat(edits().wrong(named("A"), c, "0 0 1")).isEmpty();
    assertThat(edits().wrong(instances, c, "0 0 1").orElseThrow())
        .contains("ProtoInstance B", "line 7", "entity");
    assertThat(edits().wrongReset(instances, c).orElseThrow()).contains("ProtoInstance B");
    assertThat(edits().wrong(instances, field(named("A"), "m"), "1").orElseThrow())
        .contains("ProtoInstance B", "long");
    assertThat(edits().wrong(instances, c, "2 0 x").orElseThrow()).doesNotContain("B");
    NodeField colour =
        fields(named("M")).stream()
            .filter(field -> field.name().equals("diffuseColor"))
            .findFirst()
            .orElseThrow();
    assertThat(edits().wrong(List.of(named("M"), named("N")), colour, "0 0 1").orElseThrow())
        .contains("Material N", "entity");
    List<DocumentElement> unknown = List.of(named("W"), named("V"));
    assertThat(edits().wrong(unknown, field(named("W"), "x"), "1").orElseThrow())
        .contains("ProtoInstance V", "holds nodes");
    assertThat(edits().wrong(List.of(named("W"), named("U")), field(named("W"), "x"), "2"))
        .isEmpty();
  }

  @Test
  void aValueOfAFieldThatCannotHaveOneIsToldWhy() {
    String given =
        SCENE.replace(
            "<fieldValue name=\"nonsense\" value=\"1\"/>",
            "<fieldValue name=\"nonsense\" value=\"1\"/><fieldValue name=\"hit\" value=\"1\"/>"
                + "<fieldValue name=\"move\" value=\"1\"/><fieldValue name=\"odd\" value=\"1\"/>"
                + "<fieldValue name=\"off\" value=\"1\"/>");
    document =
        document(
            given.replace(
                "<field name=\"odd\"",
                "<field name=\"off\" type=\"SFBool\" accessType=\"inputoutput\"/><field name=\"odd\""));
    assertThat(wrong("Given", "nonsense", "1").orElseThrow()).contains("has no field nonsense");
    assertThat(wrong("Given", "hit", "1").orElseThrow())
        .contains("field hit of the prototype Chair", "outputOnly")
        .doesNotContain("no field");
    assertThat(wrong("Given", "move", "1").orElseThrow()).contains("move", "inputOnly");
    assertThat(wrong("Given", "odd", "1").orElseThrow()).contains("odd", "type", "SFUnheardOf");
    assertThat(wrong("Given", "off", "1").orElseThrow())
        .contains("off", "accessType", "inputoutput");
  }

  @Test
  void whatLiesInAnotherOfTheSelectedIsLeftOut() {
    document =
        document(
            "<X3D><Scene><Group DEF='A'><Group DEF='B'/></Group><Group DEF='C'/>"
                + "<Group USE='C'/></Scene></X3D>");
    List<DocumentElement> all = List.of(named("A"), named("B"), at("<Group USE='C'/>"), named("C"));
    assertThat(edits().alike(named("C"), all)).containsExactly(named("C"), named("A"));
  }

  @Test
  void aHugeInterfaceIsCut() {
    String many =
        IntStream.range(0, 5000)
            .mapToObj(i -> "<field name='f" + i + "' type='SFBool' accessType='inputOutput'/>")
            .collect(Collectors.joining());
    document =
        document(
            "<X3D><Scene><ProtoDeclare name='P'><ProtoInterface>"
                + many
                + "</ProtoInterface><ProtoBody><Group/></ProtoBody></ProtoDeclare>"
                + "<ProtoInstance name='P' DEF='A'>"
                + "<fieldValue name='f4000' value='true'/></ProtoInstance></Scene></X3D>");
    assertThat(declared(named("A"))).hasSizeLessThan(1000).startsWith("f0", "f1");
    // What an instance gives is listed as it is declared, wherever that is.
    assertThat(wrong("A", "f4000", "false")).isEmpty();
    assertThat(wrong("A", "f4000", "2")).isPresent();
  }
}
