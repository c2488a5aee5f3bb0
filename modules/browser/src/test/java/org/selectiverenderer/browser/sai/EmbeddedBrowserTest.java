package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.web3d.x3d.sai.BrowserEvent;
import org.web3d.x3d.sai.BrowserListener;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.InvalidBrowserException;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.SFInt32;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DRoute;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.grouping.Switch;
import org.web3d.x3d.sai.navigation.Viewpoint;

class EmbeddedBrowserTest {
  private final SaiFixture sai =
      SaiFixture.showing(
          "<Viewpoint DEF='A' position='1 0 0'/><Viewpoint DEF='B' position='2 0 0'/>"
              + "<Viewpoint DEF='C' position='3 0 0'/><Switch DEF='S'/>");
  private final ExternalBrowser browser = sai.browser;

  @AfterEach
  void close() {
    sai.close();
  }

  private String bound() {
    sai.step();
    List<String> bound = new ArrayList<>();
    for (String name : List.of("A", "B", "C")) {
      if (sai.node(name, Viewpoint.class).getIsBound()) {
        bound.add(name);
      }
    }
    return String.join(",", bound);
  }

  @Test
  void viewpointsAreGoneThroughInOrderAndAroundTheEnds() {
    assertThat(bound()).isEqualTo("A");
    browser.nextViewpoint();
    assertThat(bound()).isEqualTo("B");
    browser.nextViewpoint(0);
    assertThat(bound()).isEqualTo("C");
    browser.nextViewpoint();
    assertThat(bound()).isEqualTo("A");
    browser.previousViewpoint();
    assertThat(bound()).isEqualTo("C");
    browser.previousViewpoint(0);
    assertThat(bound()).isEqualTo("B");
    browser.firstViewpoint();
    assertThat(bound()).isEqualTo("A");
    browser.lastViewpoint();
    assertThat(bound()).isEqualTo("C");
    browser.firstViewpoint(0);
    browser.lastViewpoint(0);
    assertThat(bound()).isEqualTo("C");
  }

  @Test
  void viewpointsOfASceneWithoutAnyAreNoError() {
    try (SaiFixture empty = new SaiFixture()) {
      empty.browser.nextViewpoint();
      empty.browser.lastViewpoint();
      empty.step();
      assertThat(empty.complaints()).isEmpty();
    }
  }

  @Test
  void itHasANameAndTalks() {
    assertThat(browser.getName()).isNotBlank();
    assertThat(browser.getVersion()).isNotBlank();
    browser.setDescription("mine");
    assertThat(browser.getDescription()).isEqualTo("mine");
    browser.print("a");
    browser.println(1);
    assertThat(String.join("", sai.printed)).isEqualTo("a1" + System.lineSeparator());
  }

  @Test
  void aBrowserListenerIsAddedOnceAndABadOneSilencesNobody() {
    List<Integer> heard = new ArrayList<>();
    BrowserListener listener = event -> heard.add(event.getID());
    browser.addBrowserListener(
        event -> {
          throw new AssertionError("out of luck");
        });
    browser.addBrowserListener(listener);
    browser.addBrowserListener(listener);
    browser.replaceWorld(sai.scene());
    assertThat(heard).containsExactly(BrowserEvent.INITIALIZED);
    assertThat(sai.complaints())
        .containsExactly("a browser listener failed and was skipped: out of luck");
    browser.removeBrowserListener(listener);
    browser.replaceWorld(sai.scene());
    assertThat(heard).hasSize(1);
  }

  @Test
  void nodesAndScenesOfAnotherBrowserAreRefused() {
    try (SaiFixture other = new SaiFixture()) {
      X3DNode foreign = other.make("Group");
      X3DScene scene = sai.scene();
      assertThatThrownBy(() -> scene.addRootNode(foreign))
          .isInstanceOf(InvalidNodeException.class)
          .hasMessage("the node belongs to another browser");
      assertThatThrownBy(() -> sai.node("S", Switch.class).setChildren(new X3DNode[] {foreign}))
          .isInstanceOf(InvalidNodeException.class);
      assertThatThrownBy(() -> scene.updateNamedNode("F", foreign))
          .isInstanceOf(InvalidNodeException.class);
      assertThatThrownBy(() -> browser.replaceWorld(other.scene()))
          .isInstanceOf(InvalidNodeException.class);
      assertThatThrownBy(() -> scene.addRootNode(null)).isInstanceOf(InvalidNodeException.class);
      X3DNode disposed = sai.make("Group");
      disposed.dispose();
      assertThatThrownBy(() -> scene.addRootNode(disposed))
          .isInstanceOf(InvalidNodeException.class)
          .hasMessageContaining("disposed of");
    }
  }

  @Test
  void afterDisposalEveryMethodOfEveryObjectIsRefused() throws Exception {
    List<Integer> heard = new ArrayList<>();
    browser.addBrowserListener(event -> heard.add(event.getID()));
    X3DScene scene = sai.scene();
    Switch node = sai.node("S", Switch.class);
    SFInt32 field = (SFInt32) node.getField("whichChoice");
    X3DRoute route = scene.addRoute(node, "whichChoice", sai.make("Switch"), "whichChoice");
    browser.dispose();
    browser.dispose();
    assertThat(heard).containsExactly(BrowserEvent.SHUTDOWN);

    refused(browser, ExternalBrowser.class);
    refused(scene, X3DScene.class);
    refused(node, Switch.class);
    refused(field, SFInt32.class);
    refused(route, X3DRoute.class);
  }

  private static void refused(Object object, Class<?> type) throws Exception {
    for (Method method : type.getMethods()) {
      boolean namesOnly = object instanceof X3DRoute && method.getReturnType().equals(String.class);
      if (method.getName().equals("dispose") && !(object instanceof X3DNode) || namesOnly) {
        continue;
      }
      Object[] arguments = new Object[method.getParameterCount()];
      for (int i = 0; i < arguments.length; i++) {
        Class<?> parameter = method.getParameterTypes()[i];
        arguments[i] =
            parameter == int.class
                ? 1
                : parameter == float.class ? 1f : parameter == boolean.class ? Boolean.TRUE : null;
      }
      try {
        method.invoke(object, arguments);
        throw new AssertionError(method + " is not refused");
      } catch (InvocationTargetException e) {
        assertThat(e.getCause()).as(method.toString()).isInstanceOf(InvalidBrowserException.class);
      }
    }
  }
}
