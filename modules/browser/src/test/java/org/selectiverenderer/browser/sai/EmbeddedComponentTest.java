package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.World;
import org.web3d.x3d.sai.BrowserFactory;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.InvalidBrowserException;
import org.web3d.x3d.sai.NotSupportedException;
import org.web3d.x3d.sai.X3DComponent;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.grouping.Switch;

/** The browser as applications get it that know the SAI alone. */
class EmbeddedComponentTest {
  private static Set<Thread> ours() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(
            thread ->
                thread.getName().equals("x3d-browser")
                    || thread.getName().startsWith("scene-loader-"))
        .collect(Collectors.toSet());
  }

  private static void show(ExternalBrowser browser, String nodes) {
    browser.replaceWorld(browser.createX3DFromString(SaiFixture.file(nodes)));
  }

  @Test
  void theDefaultFactoryGivesABrowserThatStepsItself() throws Exception {
    X3DComponent component = BrowserFactory.createX3DComponent(Map.of());
    try {
      ExternalBrowser browser = component.getBrowser();
      assertThat(component.getImplementation()).isInstanceOf(World.class);
      show(browser, "<Switch DEF='S'/>");
      Switch node = (Switch) ((X3DScene) browser.getExecutionContext()).getNamedNode("S");
      CountDownLatch heard = new CountDownLatch(1);
      node.getField("whichChoice").addX3DEventListener(event -> heard.countDown());
      node.setWhichChoice(2);
      assertThat(heard.await(30, TimeUnit.SECONDS)).isTrue();
    } finally {
      component.shutdown();
    }
  }

  @Test
  void shutdownEndsItsThreadsAndItsBrowser() throws Exception {
    Set<Thread> before = ours();
    X3DComponent component = new EmbeddedBrowserFactory().createComponent(Map.of());
    ExternalBrowser browser = component.getBrowser();
    show(browser, "<Group/>");
    Set<Thread> made = ours();
    made.removeAll(before);
    assertThat(made).extracting(Thread::getName).contains("x3d-browser");
    component.shutdown();
    component.shutdown();

    for (Thread thread : made) {
      thread.join(30_000);
      assertThat(thread.isAlive()).as(thread.getName()).isFalse();
    }
    assertThatThrownBy(browser::getName).isInstanceOf(InvalidBrowserException.class);
  }

  @Test
  void aListenerMayShutItDown() throws Exception {
    X3DComponent component = new EmbeddedBrowserFactory().createComponent(Map.of());
    ExternalBrowser browser = component.getBrowser();
    show(browser, "<Switch DEF='S'/>");
    Switch node = (Switch) ((X3DScene) browser.getExecutionContext()).getNamedNode("S");
    CountDownLatch down = new CountDownLatch(1);
    List<Thread> thread = new CopyOnWriteArrayList<>();
    node.getField("whichChoice")
        .addX3DEventListener(
            event -> {
              thread.add(Thread.currentThread());
              component.shutdown();
              down.countDown();
            });
    node.setWhichChoice(1);
    assertThat(down.await(30, TimeUnit.SECONDS)).isTrue();
    thread.get(0).join(30_000);
    assertThat(thread.get(0).isAlive()).isFalse();
  }

  @Test
  void parametersTakeProblemsAndWhatIsPrinted() {
    List<Problem> problems = new CopyOnWriteArrayList<>();
    List<String> printed = new ArrayList<>();
    Consumer<Problem> onProblem = problems::add;
    Consumer<String> onText = printed::add;
    X3DComponent component =
        new EmbeddedBrowserFactory()
            .createComponent(
                Map.of(
                    EmbeddedBrowserFactory.PROBLEMS,
                    onProblem,
                    EmbeddedBrowserFactory.CONSOLE,
                    onText));
    try {
      component.getBrowser().print("hello");
      show(component.getBrowser(), "<Group/><Nothing/>");
      assertThat(printed).containsExactly("hello");
      assertThat(problems).extracting(Problem::message).anyMatch(m -> m.contains("Nothing"));
    } finally {
      component.shutdown();
    }
  }

  @Test
  void aFrameThatFailsIsReportedAndTheNextOneComes() throws Exception {
    List<Problem> problems = new CopyOnWriteArrayList<>();
    Consumer<Problem> onProblem = problems::add;
    X3DComponent component =
        new EmbeddedBrowserFactory()
            .createComponent(Map.of(EmbeddedBrowserFactory.PROBLEMS, onProblem));
    try {
      World world = (World) component.getImplementation();
      CountDownLatch after = new CountDownLatch(1);
      world.post(
          () -> {
            throw new IllegalStateException("out of luck");
          });
      world.post(after::countDown);
      assertThat(after.await(30, TimeUnit.SECONDS)).isTrue();
      assertThat(problems)
          .extracting(Problem::message)
          .containsExactly("a frame failed and was skipped: out of luck");
    } finally {
      component.shutdown();
    }
  }

  @Test
  void browsersOnOtherMachinesAreNotSupported() {
    InetAddress here = InetAddress.getLoopbackAddress();
    assertThatThrownBy(() -> BrowserFactory.getBrowser(here, 1))
        .isInstanceOf(NotSupportedException.class);
  }
}
