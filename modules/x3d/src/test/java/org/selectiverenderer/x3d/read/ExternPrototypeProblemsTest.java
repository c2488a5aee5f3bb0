package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;

/** Messages about external prototypes that cannot be loaded (X3D 4.0, 4.4.5). */
class ExternPrototypeProblemsTest extends AbstractExternPrototypesTest {
  @Test
  void aMissingLibraryIsOneProblemHoweverManyNodesItWouldHaveMade() {
    X3dFile file =
        scene(
            extern("Door", "\"none.x3d#Door\"")
                + """
                <ProtoInstance name='Door' DEF='A'/><ProtoInstance name='Door' DEF='B'/>
                <Group><ProtoInstance name='Door' USE='A'/></Group>
                <TimeSensor DEF='T'/><EXPORT localDEF='A'/>
                <ROUTE fromNode='T' fromField='fraction_changed' toNode='A' toField='set_fraction'/>
                """);
    assertTold(
        "test.x3d:2:1: the prototype Door cannot be loaded: url 'none.x3d#Door' is missing; its"
            + " instances are left out");
    assertThat(file.nodes()).hasSize(2);
    assertThat(file.exports()).isEmpty();
  }

  @Test
  void aLibraryThatHasNoSuchPrototypeIsTold() throws IOException {
    write("empty.x3d", "<Group/>");
    scene(
        extern("Lmap", "\"lib/lamps.x3d#Lmap\"")
            + extern("Any", "\"empty.x3d\"")
            + "<ProtoInstance name='Lmap'/><ProtoInstance name='Any'/>");
    assertTold(
        "test.x3d:2:1: the prototype Lmap cannot be loaded: it is not in lib/lamps.x3d, which has no"
            + " prototype Lmap (did you mean Lamp?); its instances are left out",
        "test.x3d:3:1: the prototype Any cannot be loaded: it is not in empty.x3d, which declares no"
            + " prototype; its instances are left out");
  }

  @Test
  void interfacesThatDifferAreToldOncePerField() {
    scene(
        extern(
                "Lamp",
                "\"lib/lamps.x3d#Lamp\"",
                "\n<field name='on' type='SFInt32' accessType='inputOutput'/>",
                "\n<field name='at' type='SFVec3f' accessType='initializeOnly'/>",
                "\n<field name='watts' type='SFFloat' accessType='inputOutput'/>")
            + """
            <ProtoInstance name='Lamp' DEF='A'><fieldValue name='watts' value='40'/></ProtoInstance>
            <ProtoInstance name='Lamp'><fieldValue name='watts' value='60'/></ProtoInstance>
            <ScalarInterpolator DEF='S'/>
            <ROUTE fromNode='S' fromField='value_changed' toNode='A' toField='watts'/>
            """);
    assertTold(
        "test.x3d:3:1: on of the prototype Lamp is SFBool in lib/lamps.x3d, not SFInt32; it is used"
            + " as such",
        "test.x3d:4:1: at of the prototype Lamp is inputOutput in lib/lamps.x3d, not"
            + " initializeOnly; it is used as such",
        "test.x3d:5:1: the prototype Lamp of lib/lamps.x3d has no field watts; values and routes of"
            + " it are left out");
  }

  @Test
  void filesThatNameOneAnotherEnd() throws IOException {
    write("a.x3d", extern("P", "\"b.x3d#P\""));
    write("b.x3d", extern("P", "\"a.x3d#P\""));
    write(
        "c.x3d",
        extern("Q", "\"c.x3d#Q\"")
            + "<ProtoDeclare name='R'><ProtoBody><ProtoInstance name='Q'/></ProtoBody></ProtoDeclare>"
            + "<ProtoDeclare name='Q'><ProtoBody><Group><ProtoInstance name='Q'/></Group></ProtoBody>"
            + "</ProtoDeclare>");
    scene(
        extern("P", "\"a.x3d#P\"")
            + extern("Q", "\"c.x3d#Q\"")
            + "<ProtoInstance name='P'/><ProtoInstance name='Q'/>");
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(
            "the prototype P cannot be loaded: its ExternProtoDeclares refer to one another, and"
                + " no file declares it; its instances are left out",
            "the prototype Q contains itself; this instance is left out");
  }

  @Test
  void aChainOfPrototypesThatIsTooLongEnds() throws IOException {
    StringBuilder links = new StringBuilder(RED);
    for (int i = 1; i < 5000; i++) {
      links.append(extern("P" + i, "\"chain.x3d#" + (i == 1 ? "Red" : "P" + (i - 1)) + "\""));
    }
    write("chain.x3d", links.toString());
    X3dFile file =
        scene(
            extern("P31", "\"chain.x3d#P31\"")
                + extern("P4999", "\"chain.x3d#P4999\"")
                + "<Shape><Appearance><ProtoInstance name='P31'/></Appearance></Shape>"
                + "<ProtoInstance name='P4999'/>");
    assertTold(
        "chain.x3d:4973:1: the prototype P4969 cannot be loaded: more than 32 ExternProtoDeclares"
            + " refer to one another before a file declares it; its instances are left out");
    assertThat(file.nodes()).hasSize(1);
  }

  @Test
  void aLibraryOfWhichNothingIsReadIsOneProblem() throws IOException {
    Files.write(folder.resolve("picture.x3d"), new byte[] {(byte) 0x89, 'P', 'N', 'G', 0, 1, 2, 3});
    scene(extern("Red", "\"picture.x3d#Red\"") + "<ProtoInstance name='Red'/>");
    assertThat(problems.list()).hasSize(1);
    assertThat(problems.list().get(0).toString())
        .startsWith(
            "test.x3d:2:1: the prototype Red cannot be loaded: url 'picture.x3d#Red' cannot be read (")
        .endsWith("); its instances are left out");
  }

  @Test
  void aDamagedLibraryIsToldOnceWithItsPlace() throws IOException {
    Files.writeString(folder.resolve("bad.x3d"), text(RED).replace("</Scene>", "<Oops"));
    scene(
        extern("Red", "\"bad.x3d#Red\"")
            + extern("Second", "\"bad.x3d#Red\"")
            + """
            <Shape><Appearance><ProtoInstance name='Red'/></Appearance></Shape>
            <Shape><Appearance><ProtoInstance name='Second'/></Appearance></Shape>
            """);
    assertThat(problems.list()).hasSize(1);
    assertThat(problems.list().get(0).location().file()).endsWith("bad.x3d");
    assertThat(problems.list().get(0).location().line()).isEqualTo(5);
  }

  @Test
  void prototypesOfOtherFilesThatMultiplyBeyondTheLimitAreLeftOut() throws IOException {
    write("p0.x3d", "<ProtoDeclare name='P'><ProtoBody><Group/></ProtoBody></ProtoDeclare>");
    for (int i = 1; i < 8; i++) {
      write(
          "p" + i + ".x3d",
          extern("Q", "\"p" + (i - 1) + ".x3d#P\"")
              + "<ProtoDeclare name='P'><ProtoBody><Group>"
              + "<ProtoInstance name='Q'/>".repeat(10)
              + "</Group></ProtoBody></ProtoDeclare>");
    }
    X3dFile file = scene(extern("P", "\"p7.x3d#P\"") + "<ProtoInstance name='P'/>");
    assertTold(
        "test.x3d:3:1: this instance of the prototype P exceeds the limit of 10000 nodes in a file;"
            + " it is left out");
    assertThat(file.nodes()).isEmpty();
  }

  @Test
  void aPrototypeOfAnotherFileHidesALargeOneOfItsName() throws IOException {
    String many = "<Group/>".repeat(200);
    X3dFile file =
        scene(
            "<ProtoDeclare name='Red'><ProtoBody><Group>"
                + many
                + "</Group></ProtoBody></ProtoDeclare>\n<ProtoDeclare name='All'><ProtoBody>"
                + extern("Red", "\"lib/lamps.x3d#Red\"")
                + "<Group>"
                + "<Shape><Appearance><ProtoInstance name='Red'/></Appearance></Shape>".repeat(100)
                + "</Group></ProtoBody></ProtoDeclare>\n<ProtoInstance name='All'/>");
    assertTold();
    assertThat(file.nodes()).hasSize(1);
  }
}
