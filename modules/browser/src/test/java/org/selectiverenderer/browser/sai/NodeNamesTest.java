package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.entry;

import java.util.Set;
import org.junit.jupiter.api.Test;
import org.web3d.x3d.sai.InvalidExecutionContextException;
import org.web3d.x3d.sai.X3DNode;

class NodeNamesTest {
  @Test
  void theNamesOfNodesAreToldWithoutObjectsForTheOthers() {
    try (SaiFixture sai =
        SaiFixture.showing("<Group DEF='A'/><Group/><Transform><Switch DEF='B'/></Transform>")) {
      X3DNode[] roots = sai.scene().getRootNodes();
      assertThat(sai.browser.namesOf(sai.scene(), Set.of(roots)))
          .containsOnly(entry(roots[0], "A"));
      assertThat(sai.world.scene().find("B").orElseThrow().companion()).isNull();

      X3DNode inner = sai.node("B");
      assertThat(sai.browser.namesOf(sai.scene(), Set.of(inner))).containsOnly(entry(inner, "B"));
    }
  }

  @Test
  void ofSeveralNamesTheLastCounts() {
    assertTheLastOfSeveralNamesCounts("<Group DEF='A'/>");
    assertTheLastOfSeveralNamesCounts("<Group DEF='A'/><Group DEF='B'/><Group DEF='C'/>");
  }

  private static void assertTheLastOfSeveralNamesCounts(String nodes) {
    try (SaiFixture sai = SaiFixture.showing(nodes)) {
      X3DNode group = sai.node("A");
      sai.scene().updateNamedNode("Z", group);
      assertThat(sai.browser.namesOf(sai.scene(), Set.of(group))).containsOnly(entry(group, "Z"));
      sai.scene().removeNamedNode("Z");
      assertThat(sai.browser.namesOf(sai.scene(), Set.of(group))).containsOnly(entry(group, "A"));
    }
  }

  @Test
  void theBodyOfAnInstanceHasItsName() {
    try (SaiFixture sai =
        SaiFixture.showing(
            "<ProtoDeclare name='Door'><ProtoBody><Group DEF='Inside'/></ProtoBody></ProtoDeclare>"
                + "<ProtoInstance name='Door' DEF='Front'/>")) {
      X3DNode body = sai.browser.bodyOf(sai.node("Front"));
      assertThat(sai.browser.namesOf(sai.scene(), Set.of(body))).containsOnly(entry(body, "Front"));
    }
  }

  @Test
  void scenesOfOtherBrowsersAreRefused() {
    try (SaiFixture sai = new SaiFixture();
        SaiFixture other = new SaiFixture()) {
      assertThatThrownBy(() -> sai.browser.namesOf(other.scene(), Set.of()))
          .isInstanceOf(InvalidExecutionContextException.class);
    }
  }
}
