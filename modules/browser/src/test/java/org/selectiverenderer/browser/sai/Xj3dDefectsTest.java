package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.web3d.x3d.sai.ComponentInfo;
import org.web3d.x3d.sai.SFInt32;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.grouping.Switch;

/** Where Xj3D 2.3, the browser of the thesis, was measured to fail. */
class Xj3dDefectsTest {
  @Test
  void afterListenersThatThrewTwiceAllEventsAreStillDelivered() {
    try (SaiFixture sai = SaiFixture.showing("<Switch DEF='S'/>")) {
      Switch node = sai.node("S", Switch.class);
      SFInt32 choice = (SFInt32) node.getField("whichChoice");
      List<Integer> heard = new ArrayList<>();
      choice.addX3DEventListener(
          event -> {
            throw new IllegalStateException("out of luck");
          });
      choice.addX3DEventListener(
          event -> {
            throw new AssertionError("an Error even");
          });
      choice.addX3DEventListener(event -> heard.add(choice.getValue()));
      for (int i = 1; i <= 4; i++) {
        node.setWhichChoice(i);
        sai.step();
      }
      assertThat(heard).containsExactly(1, 2, 3, 4);
      assertThat(sai.complaints())
          .hasSize(8)
          .startsWith(
              "a listener of whichChoice failed and was skipped: out of luck",
              "a listener of whichChoice failed and was skipped: an Error even");
    }
  }

  @Test
  void enteringIsSeenAndTheVersionSwitchedInTheSameFrame() {
    String scene =
        "<ProximitySensor DEF='P' size='2 2 2'/><Switch DEF='S' whichChoice='1'>"
            + "<Shape><Box/></Shape><Group/></Switch>";
    try (SaiFixture sai = SaiFixture.showing(scene)) {
      Switch object = sai.node("S", Switch.class);
      sai.node("P").getField("enterTime").addX3DEventListener(e -> object.setWhichChoice(0));
      sai.walkTo(5);
      assertThat(shapes(sai)).isZero();
      sai.walkTo(0);
      assertThat(shapes(sai)).isEqualTo(1);
    }
  }

  private static long shapes(SaiFixture sai) {
    return count(sai.world.instances().root().children());
  }

  private static long count(List<? extends Instance> instances) {
    long shown = 0;
    for (Instance instance : instances) {
      if (instance.shown()) {
        shown +=
            instance instanceof ShapeInstance
                ? 1
                : instance instanceof org.selectiverenderer.browser.instance.GroupInstance group
                    ? count(group.children())
                    : 0;
      }
    }
    return shown;
  }

  @Test
  void renderingIsStartedPausedAndStopped() {
    String scene = "<TimeSensor DEF='T' loop='true' cycleInterval='100'/><Switch DEF='S'/>";
    try (SaiFixture sai = SaiFixture.showing(scene)) {
      var clock = sai.node("T", org.web3d.x3d.sai.time.TimeSensor.class);
      sai.step();
      sai.step();
      for (Runnable halt : List.<Runnable>of(sai.browser::pauseRender, sai.browser::stopRender)) {
        double before = clock.getTime();
        halt.run();
        sai.step();
        sai.node("S", Switch.class).setWhichChoice(3);
        sai.step();
        assertThat(clock.getTime()).isEqualTo(before);
        assertThat(sai.node("S", Switch.class).getWhichChoice()).isEqualTo(3);
        sai.browser.startRender();
        sai.step();
        assertThat(clock.getTime()).isGreaterThan(before);
      }
    }
  }

  @Test
  void speedAndFrameRateAreMeasured() {
    try (SaiFixture sai = SaiFixture.showing("<Group/>")) {
      assertThat(sai.browser.getCurrentFrameRate()).isZero();
      sai.walkTo(0);
      sai.walkTo(3);
      assertThat(sai.browser.getCurrentSpeed()).isEqualTo(3f);
      assertThat(sai.browser.getCurrentFrameRate()).isPositive();
      sai.walkTo(3);
      assertThat(sai.browser.getCurrentSpeed()).isZero();
    }
  }

  @Test
  void profileComponentsEncodingAndPropertiesAreTold() {
    try (SaiFixture sai = new SaiFixture()) {
      X3DScene scene =
          sai.browser.createX3DFromString(
              "<X3D version='3.3' profile='Interchange'><head>"
                  + "<component name='Navigation' level='2'/><component name='CADGeometry' level='1'/>"
                  + "</head><Scene/></X3D>");
      assertThat(scene.getSpecificationVersion()).isEqualTo("3.3");
      assertThat(scene.getProfile().getName()).isEqualTo("Interchange");
      assertThat(scene.getComponents())
          .extracting(ComponentInfo::toX3DString)
          .containsExactly(
              "<component name=\"CADGeometry\" level=\"1\"/>",
              "<component name=\"Navigation\" level=\"2\"/>");
      assertThat(scene.getEncoding()).isEqualTo(X3DExecutionContext.XML_ENCODING);
      assertThat(sai.browser.getRenderingProperties()).isEqualTo(Map.of("Antialiased", true));
      assertThat(sai.browser.getBrowserProperties())
          .containsEntry("XML_ENCODING", true)
          .containsEntry("CLASSIC_VRML_ENCODING", true)
          .containsEntry("PROTOTYPE_CREATE", false);
    }
  }

  @Test
  void importsAndExportsWork() {
    try (SaiFixture sai = SaiFixture.showing("<Switch DEF='S'/><EXPORT localDEF='S' AS='Out'/>")) {
      X3DScene scene = sai.scene();
      assertThat(scene.getExportedNodes()).containsExactly("Out");
      assertThat(scene.getExportedNode("Out")).isSameAs(sai.node("S"));
      scene.updateExportedNode("S", "More");
      scene.updateExportedNode("S", null);
      assertThat(scene.getExportedNodes()).containsExactly("Out", "More", "S");
      scene.removeExportedNode("Out");
      assertThat(scene.getExportedNodes()).containsExactly("More", "S");
    }
  }

  @Test
  void version4AndProfileFullLoad() {
    try (SaiFixture sai = new SaiFixture()) {
      X3DScene scene =
          sai.browser.createX3DFromString(
              "<X3D version='4.0' profile='Full'><Scene><Shape><Appearance>"
                  + "<PhysicalMaterial/></Appearance><Box/></Shape></Scene></X3D>");
      assertThat(scene.getRootNodes()).hasSize(1);
      assertThat(scene.getProfile().getName()).isEqualTo("Full");
      assertThat(sai.problems.any()).isFalse();
    }
  }

  @Test
  void writesBeforeReplaceWorldAreKept() {
    try (SaiFixture sai = new SaiFixture()) {
      X3DScene scene = sai.browser.createX3DFromString(SaiFixture.file("<Switch DEF='S'/>"));
      ((Switch) scene.getNamedNode("S")).setWhichChoice(2);
      sai.browser.replaceWorld(scene);
      sai.step();
      assertThat(sai.node("S", Switch.class).getWhichChoice()).isEqualTo(2);
    }
  }
}
