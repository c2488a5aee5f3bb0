package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;

/** Nodes that are imported from Inlines that come and go. */
class ImportUpdaterTest extends RunningSceneLoaderTestCase {
  private static final String SWITCHING =
      """
      <BooleanTrigger DEF='B'/>
      <IMPORT inlineDEF='I' importedDEF='Out' AS='T'/>
      <ROUTE fromNode='T' fromField='triggerTrue' toNode='L' toField='set_on'/>
      <PointLight DEF='L' on='false'/>
      """;

  private static String exporting(String before, String def) {
    return before
        + "<BooleanTrigger DEF='%s'/><EXPORT localDEF='%s' AS='Out'/>".formatted(def, def);
  }

  private Node imported(String name) {
    return loaded.scene().imported().get(name);
  }

  @Test
  void importsFollowAnInlineThatComesAndGoes() throws Exception {
    write("one.x3d", exporting("", "First"));
    write("two.x3d", exporting("<Group/>", "Second"));
    load("<Inline DEF='I' load='false' url='\"one.x3d\"'/>" + SWITCHING);
    assertThat(problems.list()).isEmpty();
    assertThat(imported("T")).isNull();
    set("I", "load", true);
    arrive();
    Node first = imported("T");
    assertThat(first.name()).isEqualTo("First");
    assertThat(loaded.scene().routes()).hasSize(1);
    set("I", "load", false);
    frame();
    assertThat(imported("T")).isNull();
    assertThat(loaded.scene().routes()).isEmpty();
    set("I", "load", true);
    frame();
    assertThat(imported("T")).isSameAs(first);
    set("I", "url", url("two.x3d"));
    arrive();
    assertThat(imported("T").name()).isEqualTo("Second");
    assertThat(loaded.scene().routes()).hasSize(1);
    set("I", "url", url("boxes1.x3d"));
    arrive();
    assertThat(imported("T")).isNull();
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly("the Inline exports no node as Out (Inline I); the IMPORT is left out");
  }

  @Test
  void anImportedNodeMayBeExportedFurther() throws Exception {
    write("one.x3d", exporting("", "First"));
    write(
        "middle.x3d",
        "<Inline DEF='J' load='false' url='\"one.x3d\"'/>"
            + "<IMPORT inlineDEF='J' importedDEF='Out' AS='Mine'/><EXPORT localDEF='Mine' AS='Out'/>");
    load("<Inline DEF='I' url='\"middle.x3d\"'/>" + SWITCHING);
    assertThat(problems.list()).isEmpty();
    assertThat(imported("T")).isNull();
    InlineNode outer = (InlineNode) node("I");
    InlineNode inner = (InlineNode) outer.content().orElseThrow().find("J").orElseThrow();
    files.watch(List.of(outer, inner));
    cascade.send(inner, inner.type().indexOf("load"), true);
    frame();
    arrive();
    assertThat(imported("T").name()).isEqualTo("First");
    assertThat(loaded.scene().routes()).hasSize(1);
  }

  @Test
  void routesReachWhatAnExportedInstanceOfAPrototypeStandsFor() throws Exception {
    write(
        "lamp.x3d",
        """
        <ProtoDeclare name='Lamp'>
          <ProtoInterface><field name='lit' type='SFBool' accessType='inputOutput'/></ProtoInterface>
          <ProtoBody><Group><PointLight><IS><connect nodeField='on' protoField='lit'/></IS></PointLight>
            <SpotLight><IS><connect nodeField='on' protoField='lit'/></IS></SpotLight></Group></ProtoBody>
        </ProtoDeclare>
        <ProtoInstance name='Lamp' DEF='A'/><EXPORT localDEF='A'/>
        """);
    load(
        """
        <Inline DEF='I' url='"lamp.x3d"'/><BooleanTrigger DEF='B'/>
        <IMPORT inlineDEF='I' importedDEF='A'/>
        <ROUTE fromNode='B' fromField='triggerTrue' toNode='A' toField='set_lit'/>
        <ROUTE fromNode='B' fromField='triggerTrue' toNode='A' toField='dim'/>
        """);
    assertThat(loaded.scene().routes())
        .extracting(route -> route.to().type().name())
        .containsExactly("PointLight", "SpotLight");
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(
            "the imported A (Group) has no field dim that receives events; the ROUTE is left out");
  }
}
